"""Codes FS8xx, what the language has and this version does not run."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

LATER: tuple[Entry, ...] = ()
