"""Codes FS1xx, what cannot be read as the language."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

SYNTAX: tuple[Entry, ...] = ()
