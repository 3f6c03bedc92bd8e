"""A script as it stands in an editor: edits are asked of the editor, which makes them and can take them back."""

from __future__ import annotations

from facescript.preview.editor import Editor
from facescript.preview.paper import Edit, Paper, Refusal
from facescript.preview.places import Units
from facescript.web.messages import Message
from facescript.world import LARGEST_SCRIPT, decode


class Borrowed(Paper):
    """The text, until the editor says what it is, as its file has it."""

    def __init__(self, editor: Editor, text: str) -> None:
        super().__init__(None, text)
        self._editor = editor

    @property
    def writable(self) -> bool:
        return True

    def hear(self, message: Message) -> bool:
        """Takes a `text` of the editor; whether it is another."""
        said = str(message["text"]).encode("utf-8", "replace")
        if len(said) > LARGEST_SCRIPT:
            return False
        self._editor.version = int(str(message["version"]))
        return self.take(decode(said.replace(b"\0", b" ")))

    def edit(self, base: int, edit: Edit) -> None:
        """Asks the editor for an edit of the text `base`. Raises `Refusal`."""
        self.check(base, edit)
        where = {"from": edit.first, "to": edit.last}
        self._editor.tell("edit", version=self._editor.version, **where, text=edit.text)

    def undo(self) -> Edit:
        """Raises `Refusal`."""
        raise Refusal("it is taken back where it was made: undo it in the editor")

    def line(self, unit: int) -> tuple[int, int]:
        """From where to where the line of a place goes, all in UTF-16 units."""
        units = Units(self.text)
        offset = units.offset(unit)
        end = self.text.find("\n", offset)
        return units.at(self.text.rfind("\n", 0, offset) + 1), units.at(len(self.text) if end < 0 else end)
