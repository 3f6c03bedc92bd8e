"""Paths as scripts write them, relative to the script, to paths of the project."""

from __future__ import annotations

from posixpath import dirname, join, normpath

from facescript.text import Span


def project_path(span: Span, path: str) -> str:
    """The path, relative to the project's folder, of a file that the script of `span` names."""
    return normpath(join(dirname(span.source.name), path))
