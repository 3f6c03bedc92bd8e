"""The table of verbs to a page each: form, what holds unless said, modifiers, an example; and an index of them."""

from __future__ import annotations

import re
from collections.abc import Iterator

from facescript.resolve.words import MODIFIERS, VERBS, Modifier, Verb
from website.page import Page, anchor, block, examples, sentence, table

FOLDER = "reference/statements"

READ = {
    "look": "language.md#5-gaze",
    "glance": "language.md#5-gaze",
    "scan": "language.md#5-gaze",
    "show": "language.md#7-muscles-sums-and-the-library",
    "add": "language.md#7-muscles-sums-and-the-library",
    "drop": "language.md#7-muscles-sums-and-the-library",
    "nod": "language.md#8-gestures",
    "shake": "language.md#8-gestures",
    "tilt": "language.md#8-gestures",
    "blink": "language.md#8-gestures",
    "wink": "language.md#8-gestures",
    "say": "language.md#10-speech-and-texts",
    "play": "language.md#recorded-faces",
    "wait": "language.md#4-time",
    "background": "language.md#13-film-faces-scenes-background-view",
    "view": "language.md#13-film-faces-scenes-background-view",
    "picture": "language.md#13-film-faces-scenes-background-view",
    "link": "language.md#13-film-faces-scenes-background-view",
    "life": "language.md#12-life",
}
"""Where the language tells of each verb."""

KINDS = {
    "TARGET": "[what can be looked at](../targets.md)",
    "CROWD": "[a target of several places](../targets.md)",
    "SUM": "[expressions, units, muscles and channels with their degrees](../values.md#sum)",
    "TIME": "[a time](../values.md#time), such as `2s`",
    "PERCENTAGE": "[how much](../values.md#percentage), such as `40%`",
    "COLOUR": "[a colour](../values.md#colour), such as `#dfe8f2`",
    "PRESET": "[a life](../lives.md) of the library or of yours",
    "FACE": "the name of [a face](../face.md)",
    "NAME": "an expression that is shown, or a name that `as` gave",
    "TEXT": "what is said, with [its signs](../../language.md#10-speech-and-texts)",
}
"""What the words in capitals of a form stand for."""


def pages() -> Iterator[Page]:
    rows = [(f"[`{verb.form}`]({verb.name}.md)", sentence(verb.help)) for verb in VERBS.values()]
    yield Page(f"{FOLDER}/index.md", "Statements", f"{HEAD}\n{table(('written', 'does'), rows)}")
    for verb in VERBS.values():
        yield Page(f"{FOLDER}/{verb.name}.md", verb.name, _text(verb))


HEAD = """\
# Statements

What a face does, a line each: `[face:] verb words, modifier, modifier`. [Blocks](../blocks.md) hold statements,
[definitions](../definitions.md) stand outside of them; [actions](../actions.md) are verbs that scripts and the
library define. When each is over, and the next begins, stands under [time](../../language.md#4-time).
"""


def _text(verb: Verb) -> str:
    parts = [f"# {verb.name}\n", block(verb.form, "face-part"), sentence(verb.help) + "\n", _kinds(verb)]
    if verb.default:
        parts.append(f"Unless said: {verb.default}.\n")
    parts += ["## Example\n", examples()[verb.name], "## Modifiers\n", _modifiers(verb)]
    return "\n".join([*parts, f"More of it: [the language]({'../../' + READ[verb.name]}).\n"])


def _kinds(verb: Verb) -> str:
    """What the words in capitals are."""
    rows = (f"- {kind}: {says}" for kind, says in KINDS.items() if re.search(rf"\b{kind}\b", verb.form))
    return "\n".join(rows) + "\n"


def _modifiers(verb: Verb) -> str:
    """Those that follow directly first, as they are written."""
    rows = sorted((MODIFIERS[name] for name in verb.modifiers), key=lambda row: (row.name == "as", not row.direct))
    return table(("written", "means"), ((_written(row), sentence(row.help)) for row in rows))


def _written(row: Modifier) -> str:
    return f"[`{'' if row.direct else ', '}{row.form}`](../modifiers.md#{anchor(row.name)})"
