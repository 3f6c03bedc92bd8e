"""Codes FS5xx, texts, voices and words."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

SPEECH: tuple[Entry, ...] = ()
