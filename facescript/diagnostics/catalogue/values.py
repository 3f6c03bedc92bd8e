"""Codes FS3xx, units, ranges and modifiers."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

VALUES: tuple[Entry, ...] = ()
