"""The colours of a document and the writing of a picked one."""

from __future__ import annotations

import pytest
from analysing import analysis
from lsprotocol import types

from facescript.lsp.features.colours import colours, presentation

NOWHERE = types.Range(types.Position(0, 0), types.Position(0, 7))


def test_colours_are_found_in_lines_and_in_texts() -> None:
    text = 'background #ff0000 to #00ff0080  # not #0000ff here\nsay "a [background #0000ff]b"\n'
    found = colours(analysis(text))
    parts = [(one.color.red, one.color.green, one.color.blue, round(one.color.alpha, 2)) for one in found]
    assert parts == [(1.0, 0.0, 0.0, 1.0), (0.0, 1.0, 0.0, 0.5), (0.0, 0.0, 1.0, 1.0)]
    assert found[0].range == types.Range(types.Position(0, 11), types.Position(0, 18))
    assert all(type(part) is float for part in parts[0])


@pytest.mark.parametrize(
    ("parts", "written"),
    [((1.0, 0.5, 0.0, 1.0), "#ff8000"), ((0.0, 0.0, 0.0, 0.5), "#00000080"), ((7.0, -1.0, 0.2, 9.0), "#ff0033")],
)
def test_a_picked_colour_is_written_as_the_language_has_it(parts: tuple[float, ...], written: str) -> None:
    found = presentation(types.Color(*parts), NOWHERE)
    assert found.label == written and found.text_edit == types.TextEdit(NOWHERE, written)
