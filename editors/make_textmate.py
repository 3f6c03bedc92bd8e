"""The grammar's words and the language's tables to a TextMate grammar: the colours of `.face` files in many editors.

Run `python editors/make_textmate.py` after a change of the grammar, the words or the library; a test holds the file
to them. Regular expressions keep to what Oniguruma and Python's `re` read alike.
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from facescript.cli.list import LISTS
from facescript.performance.channels import CHANNELS
from facescript.resolve.events import PERSONAL, TEXTUAL
from facescript.resolve.kinds.words import ROWS
from facescript.resolve.texts import ESCAPES
from facescript.resolve.units import UNITS
from facescript.resolve.words import (
    DIRECT,
    DIRECTIONS,
    EASES,
    FACE,
    FILM,
    MODIFIERS,
    NOTHING,
    VALUE,
    VERBS,
    WORDS,
    Modifier,
)
from facescript.speech.voices.registry import ENGINES
from facescript.syntax.table import table

GRAMMAR = Path(__file__).parent / "vscode" / "syntaxes" / "face.tmLanguage.json"

Rule = dict[str, Any]

NAME = r"[^\W\d]\w*(?:-[^\W\d]\w*)*"
ALONE, ENDED = r"(?<![\w.-])", r"(?![\w-])"
"""Around a word: it is no part of another name."""
WHOLE = r"(?![\w.-])"
"""After a word that no `.` follows."""

BEGINNING = r"(?:^|(?<=[:\[]))[ \t]*"
"""Where a statement may begin: in a line, behind a colon, in a text's bracket."""

TEXT = "string.quoted.double.face"

NAMED = {
    "expression": "entity.name.function.face",
    "action": "entity.name.function.face",
    "face": "entity.name.type.face",
    "kind": "entity.name.type.face",
    "life": "entity.name.type.face",
    "let": "variable.other.constant.face",
    "target": "variable.other.constant.face",
    "scene": "entity.name.section.face",
}
"""The words that define a name, and what the name is coloured as."""

KEYWORDS = frozenset(table().keywords) | {"in turn"}
DEFINING = frozenset((*NAMED, "film", "use", "viseme", "event"))
QUOTING = ("event", "on", "repeat", "scene", "use", "viseme", "when", "background", "link", "picture", "play")
"""What begins a statement with texts that nobody says."""

CHANNEL_HEADS = frozenset(channel.name.partition(".")[0] for channel in CHANNELS)
CONSTANTS = WORDS & {*DIRECTIONS, NOTHING, "all", "away", "camera", "neutral", "people"}
OTHERS = WORDS - KEYWORDS - DIRECT - CONSTANTS - CHANNEL_HEADS - set(VERBS)
"""Words of the language that stand within a statement: `until`, `forever`."""


def any_of(words: Iterable[str]) -> str:
    """One of the words, the longest first; a space in one may be several."""
    return "(?:" + "|".join(w.replace(" ", " +") for w in sorted(words, key=lambda w: (-len(w), w))) + ")"


def words(scope: str, listed: Iterable[str], after: str = ENDED) -> Rule:
    return {"name": scope, "match": ALONE + any_of(listed) + after}


def spots(match: str, *scopes: str) -> Rule:
    """A rule whose groups have these scopes."""
    return {"match": match, "captures": _captures(scopes)}


def include(*names: str) -> list[Rule]:
    return [{"include": f"#{name}"} for name in names]


def _captures(scopes: Iterable[str]) -> dict[str, Rule]:
    return {str(number): {"name": scope} for number, scope in enumerate(scopes, 1) if scope}


def _first(rows: Iterable[Modifier]) -> list[str]:
    """How modifiers begin: `head`, `eyes then head`."""
    return [" ".join(w for w in row.pattern if w != VALUE) for row in rows if row.pattern[0] != VALUE]


def _last(rows: Iterable[Modifier]) -> list[str]:
    """The word behind the value of those that end in one: `each`."""
    return [row.pattern[1] for row in rows if row.pattern[0] == VALUE and len(row.pattern) > 1]


def _library(what: str) -> list[str]:
    return [name.partition(" ")[0].partition(",")[0] for name, _ in LISTS[what]()]


ALL_MODIFIERS = (*MODIFIERS.values(), *FACE.values(), *FILM.values())
AFTER_COMMA = frozenset(_first(ALL_MODIFIERS)) - DIRECT
FILES = [row.pattern[0] for row in ALL_MODIFIERS if row.takes in ("file", "text")]


def grammar() -> Rule:
    """The whole grammar, as its JSON file has it."""
    return {
        "name": "FaceScript",
        "scopeName": "source.face",
        "fileTypes": ["face"],
        "patterns": [{"name": "comment.line.number-sign.face", "match": r"\A#!.*"}, *include("script")],
        "repository": {
            "script": {"patterns": include("comment", "goes-on", "blocks", "definitions", "statements", "phrases")},
            "comment": {"name": "comment.line.number-sign.face", "match": r"#(?:[ \t].*)?$"},
            "goes-on": {"patterns": [_goes_on(",", _modifiers()), _goes_on("[+=]", "(?!)")]},
            "blocks": {"patterns": [_block("face", FACE), _block("life", AFTER_COMMA), _kind()]},
            "definitions": {"patterns": _definitions()},
            "statements": {"patterns": [*_statements(), *include("subject", "verb", "call-of-action")]},
            "subject": spots(f"{BEGINNING}({NAME})[ \\t]*(?=:)", NAMED["face"]),
            "verb": spots(f"{BEGINNING}({any_of(VERBS)}){ENDED}", "support.function.verb.face"),
            "call-of-action": spots(f"{BEGINNING}({NAME})(?![\\w.-]|[ \\t]*\\()", NAMED["action"]),
            "phrases": {"patterns": [*include("comment", "texts", "numbers"), *_phrases(), *_words(), *_signs()]},
            "numbers": {"patterns": _numbers()},
            "texts": {"patterns": [_told(), _text(["escape", "cue"])]},
            "quoted": _text(["escape"]),
            "escape": {"patterns": _escapes()},
            "cue": {"patterns": _cues()},
        },
    }


def _modifiers() -> str:
    return f"({any_of(AFTER_COMMA)}){WHOLE}"


def _goes_on(sign: str, first: str) -> Rule:
    """A line that ends in `sign`: the next one's beginning is no statement's, but may be a modifier's."""
    return {
        "begin": f"({sign})[ \\t]*(?=#[ \\t]|#?$)",
        "beginCaptures": _captures(["punctuation.separator.face" if sign == "," else "keyword.operator.face"]),
        "end": f"^[ \\t]*(?:{first}|(?=[^\\s#]|#\\S))",
        "endCaptures": _captures(["keyword.other.modifier.face"]),
        "patterns": include("comment"),
    }


def _block(word: str, rows: Iterable[str]) -> Rule:
    """A definition with settings below it, to the next line that is not indented."""
    return {
        "begin": f"^({word})[ \\t]+({NAME})(?=[ \\t]*=)",
        "beginCaptures": _captures(["storage.type.face", NAMED[word]]),
        "end": r"^(?=[^\s#])",
        "patterns": [
            spots(f"^[ \\t]+({any_of(rows)}){WHOLE}", "keyword.other.modifier.face"),
            *include("comment", "goes-on", "phrases"),
        ],
    }


def _kind() -> Rule:
    """The rows of a face that is drawn: a word, and clauses that each begin with one."""
    block = _block("kind", ROWS)
    clause = spots(f"(,)[ \\t]*({NAME}){WHOLE}", "punctuation.separator.face", "keyword.other.modifier.face")
    shape = spots(f"^[ \\t]+(shape)[ \\t]+({NAME})", "keyword.other.modifier.face", "variable.other.constant.face")
    goes_on = _goes_on(",", f"({NAME}){WHOLE}")
    return {**block, "patterns": [shape, block["patterns"][0], goes_on, clause, *include("phrases")]}


def _definitions() -> list[Rule]:
    given = {
        "begin": f"^[ \\t]*(expression|action)[ \\t]+({NAME})(\\()",
        "beginCaptures": _captures(["storage.type.face", NAMED["action"], "punctuation.section.parens.face"]),
        "end": r"(\))|$",
        "endCaptures": _captures(["punctuation.section.parens.face"]),
        "patterns": [
            spots(f"(?<=[(,])[ \\t]*({NAME})(?=[ \\t]*[,)=])", "variable.parameter.face"),
            *include("phrases"),
        ],
    }
    named = [
        spots(f"^[ \\t]*({word})[ \\t]+({NAME}){'(?=[ ]*=)' if word == 'life' else ''}", "storage.type.face", scope)
        for word, scope in NAMED.items()
        if word != "scene"
    ]
    how = f"^[ \\t]*(target)[ \\t]+({NAME})[ \\t]+(at|from|moves|of){ENDED}"
    target = spots(how, "storage.type.face", NAMED["target"], "keyword.other.modifier.face")
    bare = DEFINING - set(QUOTING) - {"life"}
    return [given, target, *named, spots(f"^[ \\t]*({any_of(bare)}){ENDED}", "storage.type.face")]


def _statements() -> list[Rule]:
    """Blocks, and statements with texts that are not spoken."""
    defining = sorted(DEFINING & set(QUOTING))
    scene = _quoting(f"^[ \\t]*(scene)[ \\t]+({NAME})", "storage.type.face", NAMED["scene"])
    events = words("keyword.other.event.face", (*TEXTUAL, *PERSONAL))
    blocks = sorted(KEYWORDS - DEFINING - {"life", "with"})
    quoting = sorted(set(QUOTING) & set(blocks))
    return [
        scene,
        _quoting(f"{BEGINNING}({any_of(defining)}){ENDED}", "storage.type.face", extra=[events]),
        _quoting(f"{BEGINNING}({any_of(quoting)}){ENDED}", "keyword.control.face", extra=[events]),
        _quoting(f"{BEGINNING}({any_of(set(QUOTING) & set(VERBS))}){ENDED}", "support.function.verb.face"),
        spots(f"{BEGINNING}({any_of((set(blocks) - set(QUOTING)) | OTHERS)}){ENDED}", "keyword.control.face"),
    ]


def _quoting(begin: str, *scopes: str, extra: Iterable[Rule] = ()) -> Rule:
    return {
        "begin": begin,
        "beginCaptures": _captures(scopes),
        "end": "(?=:)|(?=,[ \\t]*$)|$",
        "patterns": [*include("comment", "quoted"), *extra, *include("phrases")],
    }


def _phrases() -> list[Rule]:
    """What several signs together are."""
    modifier, comma = "keyword.other.modifier.face", "punctuation.separator.face"
    return [
        spots(f"{ALONE}(as)[ \\t]+({NAME})", modifier, "entity.name.label.face"),
        {"name": "constant.other.language.face", "match": f"(?<=voice ){NAME}"},
        spots(f"{ALONE}(ease)[ \\t]+({any_of(EASES)}){ENDED}", modifier, "constant.language.face"),
        spots(f"(,)[ \\t]*{_modifiers()}", comma, modifier),
        spots(f"(,)[ \\t]*(?!{any_of(DIRECT)}{ENDED})({NAME})(?=[ \\t]+[^\\s,#:])", comma, "variable.parameter.face"),
        spots(f"(?<=[(,])[ \\t]*({NAME})(?=[ \\t]*=)", "variable.parameter.face"),
        spots(f"({NAME})(?=\\()", NAMED["expression"]),
        words("support.variable.channel.face", (rf"{head}(?:\.\w+)+" for head in CHANNEL_HEADS)),
        {"match": f'{ALONE}{NAME}(?:\\.(?:{NAME}|[0-9]+|"[^"\\n]*"))+', "captures": {"0": {"patterns": _dotted()}}},
    ]


def _dotted() -> list[Rule]:
    """The parts of `hello."cup".end` and `smile.left`."""
    return [
        {"name": TEXT, "match": r'"[^"\n]*"'},
        spots(f"(\\.)({NAME}|[0-9]+)", "punctuation.accessor.face", "variable.other.member.face"),
        {"name": "punctuation.accessor.face", "match": r"\."},
        *_words(),
    ]


def _words() -> list[Rule]:
    """Words alone: the language's, the library's, and the author's."""
    modifier, library = "keyword.other.modifier.face", "support.constant.expression.face"
    return [
        words(modifier, (*DIRECT, *_last(ALL_MODIFIERS), "at", "in", "with")),
        words("constant.language.face", CONSTANTS),
        words("keyword.control.face", OTHERS),
        words("support.variable.channel.face", CHANNEL_HEADS),
        words(library, (r"AU[0-9]+", *(name for name in _library("expressions") if not name.startswith("AU")))),
        words("support.type.face", (*_library("faces"), *_library("lives"))),
        {"name": "variable.other.face", "match": NAME},
    ]


def _numbers() -> list[Rule]:
    units = any_of(UNITS)
    number = r"(?:(?<![\w.)])-)?(?<![\w.])[0-9]+(?:\.[0-9]+)?"
    return [
        {"name": "constant.numeric.face", "match": '(?<=")\\.[0-9]+'},
        {"name": "constant.numeric.size.face", "match": r"(?<![\w.])[0-9]+x[0-9]+(?![\w.%])"},
        {"name": "constant.other.color.rgb-value.face", "match": r"#[0-9a-fA-F]{6}(?:[0-9a-fA-F]{2})?(?!\w)"},
        {
            "name": "constant.numeric.face",
            "match": f"{number}({units})?(?![\\w.%])",
            "captures": {"1": {"name": "keyword.other.unit.face"}},
        },
    ]


def _signs() -> list[Rule]:
    return [
        {"name": "punctuation.separator.face", "match": ","},
        {"name": "punctuation.section.block.face", "match": ":"},
        {"name": "punctuation.section.parens.face", "match": r"[()]"},
        {"name": "keyword.operator.face", "match": r"[-+*/=]"},
    ]


def _text(inside: Iterable[str], before: str = "", *scopes: str) -> Rule:
    """A text to its closing quote, or to its line's end where that is missing."""
    quote = f"{TEXT} punctuation.definition.string"
    return {
        "begin": f'{before}(")',
        "beginCaptures": _captures([*scopes, f"{quote}.begin.face"]),
        "end": r'(")|$',
        "endCaptures": _captures([f"{quote}.end.face"]),
        "contentName": TEXT,
        "patterns": include(*inside),
    }


def _told() -> Rule:
    """A text behind a word that says what it is: a file, a title, a voice."""
    before = any_of((*FILES, *ENGINES, "text", "ssml"))
    return _text(["escape"], f"{ALONE}({before})[ \\t]+", "keyword.other.modifier.face")


def _escapes() -> list[Rule]:
    known = "".join("\\" + sign for sign in ESCAPES)
    return [
        {"name": "constant.character.escape.face", "match": f"\\\\[{known}]"},
        {"name": "invalid.illegal.escape.face", "match": r"\\."},
    ]


def _cues() -> list[Rule]:
    """What stands in a spoken text besides its words."""
    bracket = {"beginCaptures": _captures(["punctuation.section.brackets.face", "keyword.control.face"])}
    ended = {"end": r'(\])|(?=")|$', "endCaptures": _captures(["punctuation.section.brackets.face"])}
    return [
        {"name": "punctuation.section.brackets.face", "match": r"\[[ \t]*/[ \t]*\]"},
        {"begin": r"(\[)[ \t]*(read)\b", **bracket, **ended, "contentName": "constant.other.reading.face"},
        {
            "begin": r"(\[)",
            **bracket,
            **ended,
            "contentName": "meta.embedded.cue.face",
            "patterns": [*include("verb", "numbers"), *_phrases(), *_words(), *_signs()],
        },
        {"name": "markup.bold.face", "match": r'\*[^*"\[\]|\\]*\*'},
        {"name": "keyword.operator.breath.face", "match": r"\|"},
    ]


def text() -> str:
    """The file's text."""
    return json.dumps(grammar(), indent=2, ensure_ascii=False) + "\n"


if __name__ == "__main__":
    GRAMMAR.write_text(text(), "utf-8", newline="\n")
    print(f"wrote {os.path.relpath(GRAMMAR)}")
