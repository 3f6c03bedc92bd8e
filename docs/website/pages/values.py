"""The tables of units and given words to the page of values, and the ways of saying a target to a page of targets."""

from __future__ import annotations

from collections.abc import Iterator

from facescript.resolve.units import EXAMPLES, LARGEST, UNITS, article, written
from facescript.resolve.words import DEFINITIONS, EASES, GIVEN, JOINING
from website.page import Page, block, sentence, shown, table


def pages() -> Iterator[Page]:
    yield Page("reference/values.md", "Values and words", "\n".join(_values()))
    yield Page("reference/targets.md", "Targets", "\n".join(_targets()))


def _values() -> Iterator[str]:
    yield "# Values and words\n"
    yield "A unit touches its number. Sums, brackets and draws (`1s to 3s`) stand wherever a quantity does\n"
    yield "([units and arithmetic](../language.md#3-units-and-arithmetic)).\n"
    for kind, example in EXAMPLES.items():
        rows = [(f"`{name}`", unit.called) for name, unit in UNITS.items() if unit.kind == kind]
        yield f"## {kind} {{#{kind.replace(' ', '-')}}}\n"
        yield f"{sentence(article(kind))[:-1]}, such as `{example}`; at most `{written(kind, LARGEST[kind])}`.\n"
        if rows:
            yield table(("unit", "is"), rows)
    yield SUM
    yield "## Words that stand for something\n"
    yield table(("word", "is"), ((f"`{name}`", sentence(says)) for name, says in (GIVEN | JOINING).items()))
    yield f"The curves of `ease`: {', '.join(f'`{name}`' for name in EASES)}.\n"


SUM = """\
## sum {#sum}

Expressions, units of FACS, muscles and channels, added and subtracted: `smile 40% + AU4 10% - brow.outer.left 20% +
head.roll 8deg`. The percentage behind a name is its degree, a name alone is 100 %; most names take `.left` or `.right`
([sums](../language.md#7-muscles-sums-and-the-library), [expressions](expressions.md), [units of FACS](units.md),
[muscles](muscles.md), [channels](channels.md)).

## colour {#colour}

`#rrggbb`, or `#rrggbbaa` with opacity; `#102040 to #304060` is a course of colours.
"""

FORMS = (
    ("camera", "", "camera", "Straight ahead, where a face looks until told."),
    (
        "a place by its direction",
        "target lamp at 25deg 10deg 2m",
        "lamp",
        "Azimuth (+ is the viewer's right), elevation, distance from the picture's centre.",
    ),
    (
        "a place in the room",
        "target cup at 25cm -14cm 25cm",
        "cup",
        "x to the viewer's right, y up, z out of the screen.",
    ),
    (
        "a place in the picture",
        "target chart at -45% 30%",
        "chart",
        "Shares of the picture's width and height from its centre.",
    ),
    (
        "one of a crowd",
        "target crowd of (-60cm 0cm 1m) (0cm 5cm 1m) (60cm 10cm 1m)",
        "crowd.3",
        "Members are counted from 1; `crowd.nearest` is the nearest.",
    ),
    (
        "what moves",
        "target fly moves\n    0s -60cm 0cm 1m\n    1s -50cm 25cm 1m",
        "fly",
        'Keys below; `lost` between two keys says that nobody sees it; `from "track.csv"` follows a file.',
    ),
)
"""Forms of targets that one face can look at: what it is, its definition, how it is named, a sentence."""


def _targets() -> Iterator[str]:
    yield "# Targets\n"
    yield f"What `look at`, `glance` and `scan` take. {sentence(DEFINITIONS['target'].help)}\n"
    for title, defined, name, says in FORMS:
        script = f"{defined}\nlook at {name}".lstrip()
        yield f"## {sentence(title)[:-1]}\n"
        yield f"{says}\n"
        yield block(script)
        whole = f"film 480x360\nface x = woman\n    life still\n{script}\nwait 1s\n"
        yield shown(whole, f"A woman looks at {title}.", 240)
    yield OTHERS


OTHERS = """\
## Another face

`bruno`, `bruno.eyes` or `bruno.mouth`: a face that is in the scene and is seen.

```face
face ada = woman
face bruno = man
ada: look at bruno.mouth
```

## A person of a reaction

The name that `when person arrives as guest:` gives, and `people.nearest`
([reactions](../language.md#16-reactions-and-events)).

## A direction

`look left 20deg up 5deg` and `look away` take no target: a direction turns from straight ahead.
"""
