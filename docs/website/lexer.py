"""The scopes of a script to a Pygments lexer: the colours that editors give are those of the pages."""

from __future__ import annotations

from collections.abc import Iterator

from pygments import lexers
from pygments.lexer import Lexer
from pygments.token import Comment, Error, Keyword, Name, Number, Operator, Punctuation, String, Text, _TokenType

from website.textmate import scopes

__all__ = ["FaceLexer"]
"""What Pygments asks a module for."""

COLOURS: dict[str, _TokenType] = {
    "comment": Comment,
    "constant.character": String.Escape,
    "constant.numeric": Number,
    "constant.other.color": Number,
    "constant": Keyword.Constant,
    "entity.name": Name.Function,
    "invalid": Error,
    "keyword.operator": Operator,
    "keyword.other.unit": Number,
    "keyword": Keyword,
    "markup": String.Interpol,
    "punctuation.definition.string": String,
    "punctuation": Punctuation,
    "storage": Keyword,
    "string": String,
    "support.function": Keyword,
    "support": Name.Constant,
    "variable.parameter": Name.Variable,
    "variable": Name,
    "": Text,
}
"""By how a scope begins; the first that fits."""


class FaceLexer(Lexer):
    """`.face` scripts, those with faults and parts of them."""

    name = "FaceScript"
    aliases = ("face", "face-bad", "face-part")
    filenames = ("*.face",)

    def get_tokens_unprocessed(self, text: str) -> Iterator[tuple[int, _TokenType, str]]:
        start = 0
        for line, stretches in scopes(text.removesuffix("\n")):
            for first, last, scope in stretches:
                yield start + first, _colour(scope), line[first:last]
            yield start + len(line), Text, "\n"
            start += len(line) + 1


def _colour(scope: str) -> _TokenType:
    return next(colour for begins, colour in COLOURS.items() if scope.startswith(begins))


def register() -> None:
    """Let Pygments know the lexer by its aliases."""
    lexers.LEXERS["FaceLexer"] = (__name__, FaceLexer.name, FaceLexer.aliases, FaceLexer.filenames, ())
