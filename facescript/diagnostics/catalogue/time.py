"""Codes FS4xx, times that cannot be solved."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

TIME: tuple[Entry, ...] = ()
