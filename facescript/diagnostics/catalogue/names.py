"""Codes FS2xx, names that are unknown, taken or unused."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

NAMES: tuple[Entry, ...] = ()
