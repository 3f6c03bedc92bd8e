"""What a call or a statement takes, while it is written."""

from __future__ import annotations

import pytest
from analysing import analysis
from lsprotocol import types

from facescript.lsp.features.signature import signature
from facescript.lsp.places import position
from facescript.text import Source

SCRIPT = """\
expression wry(lift = 40%, much) = smile.left much + AU7 lift
# A greeting.
action greet(who, warmth = 60%):
    look at who
    show smile warmth
"""
KNOWN = analysis(SCRIPT)


def at_hand(line: str) -> tuple[str, str]:
    """What is shown at the `|` of a line, and which part of it is at hand."""
    text = SCRIPT + line
    source = Source("a.face", text.replace("|", ""))
    found = signature(KNOWN, source, position(source, text.index("|")))
    if found is None:
        return "", ""
    (shown,) = found.signatures
    parts = shown.parameters or ()
    active = found.active_parameter if found.active_parameter is not None else len(parts)
    where = parts[active].label if active < len(parts) else (0, 0)
    assert isinstance(where, tuple)
    return shown.label, shown.label[slice(*where)].strip(" ,")


@pytest.mark.parametrize(
    ("line", "label", "part"),
    [
        ("show wry(|", "wry(lift = 40%, much)", "lift = 40%"),
        ("show wry(20%, |", "wry(lift = 40%, much)", "much"),
        ("show wry(much = |", "wry(lift = 40%, much)", "much"),
        ("show smile + wry(20%, 3|", "wry(lift = 40%, much)", "much"),
        ("greet |", "greet who, warmth = 60%", "who"),
        ("greet camera, |", "greet who, warmth = 60%", ""),
        ("greet camera, warmth |", "greet who, warmth = 60%", "warmth = 60%"),
        ("nod |", "nod PERCENTAGE for TIME as NAME", "nod PERCENTAGE"),
        ("nod 40% for |", "nod PERCENTAGE for TIME as NAME", "for TIME"),
        ("nod  # wry(|", "", ""),
        ('say "wry(|', "", ""),
        ("|", "", ""),
        ("show smile(|", "", ""),
    ],
)
def test_the_part_at_hand(line: str, label: str, part: str) -> None:
    assert at_hand(line) == (label, part)


def test_a_verb_says_what_its_modifiers_do() -> None:
    found = signature(KNOWN, Source("a.face", "look at camera, eyes only"), types.Position(0, 25))
    assert found is not None and found.active_parameter is not None
    (shown,) = found.signatures
    assert shown.parameters is not None and shown.parameters[found.active_parameter].documentation == "the head stays"
