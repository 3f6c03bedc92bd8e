"""Codes FS7xx, files, outputs and the command line."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry

FILES: tuple[Entry, ...] = ()
