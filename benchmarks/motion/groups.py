"""The groups of measures by name, and how two processes share them."""

from __future__ import annotations

import accents
import blinks
import conversation
import expressions
import eye_head
import pursuit
import saccades
import screen
import speech
import vergence
from table import Measures

GROUPS: dict[str, Measures] = {
    module.__name__: module.MEASURES
    for module in (
        saccades, eye_head, pursuit, vergence, blinks, expressions, speech, accents, conversation, screen
    )
}  # fmt: skip

HALVES = (
    ("saccades", "eye_head", "pursuit", "vergence", "screen", "expressions", "speech"),
    ("conversation", "blinks", "accents"),
)
"""Which process measures what, so that both are busy about as long."""
