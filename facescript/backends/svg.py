"""A performance to an animated `.svg`: one element a shape, its outline animated by SMIL, the sound inside."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import IO

from lxml import etree

from facescript.backends.job import Job
from facescript.backends.svg_animation import Animation, animate
from facescript.backends.svg_paint import gradient, paint_of
from facescript.backends.svg_sound import sound_address
from facescript.rig.picture import Shape

SVG = "http://www.w3.org/2000/svg"
XHTML = "http://www.w3.org/1999/xhtml"
PLAYER = Path(__file__).with_name("svg_player.js")
