"""Codes FS24x, kinds of faces that an author draws."""

from __future__ import annotations

from facescript.diagnostics.catalogue.model import Entry
from facescript.diagnostics.model import Severity

_HEAD = """\
kind dot = eyes 100 apart, at 360 320
    colours skin.base #ffe0a0, line.base #403020
    outline (0 -150) (120 0) (0 150)
    shell 1.3 1.6
    nose base 60, width 20
    eye half-width 26, up 16, down 12, inner 2, outer -2, iris 13, iris-y 0, crease -6 -18 -22 -20 -8, crease-width 2,
        shade 5, line 0 2 3 3 2, wing 4 -3
    mouth y 90, half-width 36, corner -2, upper 6, lower 8, tubercle 1, bow 8, dip 2, under 5, line 1.5, tick -2,
        nose-base 60, wing 22 54
"""
_SHAPES = """\
    shape face, in face, law contour, fill skin.base, half (0 -150) (120 0) (0 150)
    shape mouth-cavity, fill #401010
    shape mouth-lip-lower, fill line.base
    shape mouth-lip-upper, fill line.base
    shape eye-white, each side, fill #ffffff
    shape eye-iris, each side, fill line.base, clip eye-white
"""
_USE = "face dora = dot\ndora: nod\n"
_GOOD = _HEAD + _SHAPES + _USE
_CROWD = "".join(f"    shape s{k}, in face, law skin, fill skin.base, spot (0 0 1 1)\n" for k in range(400))

KINDS: tuple[Entry, ...] = (
    Entry(
        "FS240",
        "unknown-row",
        Severity.ERROR,
        "`{name}` is no line of a kind{meant}",
        _HEAD + "    colour skin.light #ffffff\n" + _SHAPES + _USE,
        _GOOD,
        "The lines of a kind, and what each says, are in the manual under Draw your own face.",
    ),
    Entry(
        "FS241",
        "row-unread",
        Severity.ERROR,
        "`{text}` cannot stand here; it is written `{form}`.",
        _HEAD + "    shape nose, in nose, law nose, fill skin.base, outline (0 0) (10)\n" + _SHAPES + _USE,
        _HEAD + "    shape nose, in nose, law nose, fill skin.base, outline (0 0) (10 4) (0 8)\n" + _SHAPES + _USE,
        "A point is `(x y)` in points of the art box, `(x y sharp)` at a corner; a stroke's has its width as well.",
    ),
    Entry(
        "FS242",
        "unknown-in-kind",
        Severity.ERROR,
        "`{name}` is no {what}{meant}",
        _HEAD + _SHAPES + "    muscle cheek.lowr, moves face, by (0 -4)\n" + _USE,
        _HEAD + _SHAPES + "    muscle cheek.lower, moves face, by (0 -4)\n" + _USE,
        "Layers, laws of depth, colours, shapes and muscles are known by their names.",
    ),
    Entry(
        "FS243",
        "too-far",
        Severity.ERROR,
        "`{text}` is too much; a kind's numbers go to {most}.",
        _HEAD + "    shape spot, in face, law skin, fill skin.base, spot (0 9000 5 5)\n" + _SHAPES + _USE,
        _HEAD + "    shape spot, in face, law skin, fill skin.base, spot (0 90 5 5)\n" + _SHAPES + _USE,
    ),
    Entry(
        "FS244",
        "kind-incomplete",
        Severity.ERROR,
        "`{name}` lacks {what}; it is written `{form}`.",
        _HEAD + "    shape nose, in nose, law nose, fill skin.base\n" + _SHAPES + _USE,
        _HEAD + "    shape nose, in nose, law nose, fill skin.base, spot (0 50 8 6)\n" + _SHAPES + _USE,
    ),
    Entry(
        "FS245",
        "live-shape",
        Severity.ERROR,
        "`{name}` is drawn by the face itself: it has no outline of its own and lies in the layer `{layer}`.",
        _HEAD + _SHAPES + "    shape eye-pupil, each side, in face, fill #000000, clip eye-white\n" + _USE,
        _HEAD + _SHAPES + "    shape eye-pupil, each side, fill #000000, clip eye-white\n" + _USE,
    ),
    Entry(
        "FS246",
        "kind-too-large",
        Severity.ERROR,
        "The kind `{name}` has {count} {what}; {most} is the most.",
        _HEAD + _CROWD + _SHAPES + _USE,
        _GOOD,
    ),
    Entry(
        "FS247",
        "offsets-do-not-fit",
        Severity.ERROR,
        "`{name}` has {count} points, and {given} offsets are written; write one for each, or one for all of it.",
        _HEAD + _SHAPES + "    muscle chin, moves face, by (0 -4) (0 -2)\n" + _USE,
        _HEAD + _SHAPES + "    muscle chin, moves face, by (0 -4)\n" + _USE,
        "Half an outline has its mirrored points as well, a stroke two for each of its points but a pointed end.",
    ),
    Entry(
        "FS248",
        "look-not-there",
        Severity.WARNING,
        "A `{kind}` has no {name}, so this changes nothing.",
        _HEAD + _SHAPES + "face dora = dot, glasses round\ndora: nod\n",
        _GOOD,
        "Every script plays on every kind of face; what a kind does not have is left out.",
    ),
    Entry(
        "FS249",
        "unknown-look",
        Severity.ERROR,
        "`{text}` is no {name} of a `{kind}`{meant}",
        "face ada = woman, hair purpel\nada: nod\n",
        "face ada = woman, hair #5b3a92\nada: nod\n",
        "`facescript list looks` has all that each kind of face may choose from.",
    ),
)
