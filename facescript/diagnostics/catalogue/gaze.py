"""Codes FS6xx, targets that cannot be reached."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

GAZE: tuple[Entry, ...] = ()
