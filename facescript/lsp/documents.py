"""An editor's changes to the text of a document, whatever signs end lines in other places.

Lines end where the protocol says: at a line feed, a carriage return, or both. (Python's `splitlines`, which pygls goes
by, knows more ends, such as a form feed; behind one of these every later edit would land in the wrong line.)
"""

from __future__ import annotations

import re

from lsprotocol import types
from pygls.workspace import TextDocument, Workspace

from facescript.lsp.places import column

LINE_END = re.compile(r"\r\n|\n|\r")


class Document(TextDocument):
    """A text that is edited by ranges of lines and UTF-16 columns."""

    def _apply_incremental_change(self, change: types.TextDocumentContentChangePartial) -> None:
        text = self.source
        start, end = (offset(text, place) for place in (change.range.start, change.range.end))
        self._source = text[:start] + change.text + text[max(start, end) :]


class Documents(Workspace):
    """The documents of an editor."""

    def _create_text_document(
        self, doc_uri: str, source: str | None = None, version: int | None = None, language_id: str | None = None
    ) -> Document:
        return Document(doc_uri, source, version, language_id, sync_kind=self._sync_kind)


def offset(text: str, place: types.Position) -> int:
    """The offset of a position in a text with any line ends; one beyond its line is the line's end, one beyond the text
    the text's, one in the middle of a character is before it."""
    start, ends = 0, LINE_END.finditer(text)
    for _ in range(place.line):
        end = next(ends, None)
        if end is None:
            return len(text)
        start = end.end()
    last = next(ends, None)
    line = text[start : last.start() if last else len(text)]
    return start + column(line, place.character)
