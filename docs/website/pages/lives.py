"""The library's lives, their knobs and its actions to their pages."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.lsp.vocabulary import parameters_of
from facescript.resolve.names import Definition
from facescript.resolve.words import KNOBS, MODIFIERS
from website.library import comment, defined, written
from website.page import Page, block, heading, sentence, table

SHOWN = """\
film 400x400, seed 5
face x = woman
    life {name}
wait 5s
"""


def pages() -> Iterator[Page]:
    yield Page("reference/lives.md", "Lives", LIFE_HEAD + _knobs() + "\n".join(_life(each) for each in defined("life")))
    yield Page("reference/actions.md", "Actions", ACTION_HEAD + "\n".join(_action(each) for each in defined("action")))


LIFE_HEAD = """\
# Lives

What a face does unasked: blinks, brow raises, sway, nods before pauses, small saccades, looks away. A life is a
preset with knobs (`life calm, blink 8/min`); it stands [under a face](face.md), [in a scene](statements/life.md) or
[has a name](definitions.md#life). `calm` is the usual one. [The language](../language.md#12-life) says how they
move.

"""

ACTION_HEAD = """\
# Actions

The library's verbs for talk in turns. The first argument follows the name, the others are modifiers by name
(`listen ada, lasting 2s`). Scripts [define](definitions.md#action) their own. [The
language](../language.md#14-definitions) has a dialogue with them.

"""


def _knobs() -> str:
    rows = ((f"`{MODIFIERS[name].form}`", sentence(MODIFIERS[name].help)) for name in KNOBS)
    return table(("knob", "is"), rows) + "\n"


def _life(each: Definition) -> str:
    fence = f'```face-picture {{film="0s to 5s" wide="240" alt="Five seconds of {each.name}."}}\n'
    return "\n".join(
        [heading(each.name), block(written(each), "face-part"), f"{fence}{SHOWN.format(name=each.name)}```\n"]
    )


def _action(each: Definition) -> str:
    given = [" ".join(parameter.span.text.split()) for parameter in parameters_of(each)]
    form = ", ".join([" ".join([each.name, *given[:1]]), *given[1:]])
    return "\n".join(
        [
            heading(each.name),
            block(form, "face-part"),
            sentence(comment(each)) + "\n",
            "As it stands in the library:\n",
            block(each.node.span.text, "face-part"),
        ]
    )
