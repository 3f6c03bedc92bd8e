"""Kinds of faces that are read from data: what a row becomes, and what each fault is told as."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from plays import play_of, resolved

from facescript.diagnostics.catalogue.kinds import KINDS
from facescript.ir.kind import Kind
from facescript.resolve.kinds.checks import anchors
from facescript.resolve.kinds.library import kind_names, library_head, library_kind
from facescript.rig.cartoon.drawn import outlined

GOOD = next(entry.good for entry in KINDS if entry.code == "FS240")


LATE = ("shape", "muscle", "shade")
"""Rows that stand below those of measures and colours."""


def script(*rows: str) -> str:
    """The catalogue's example with more rows: measures above its first shape, shapes and what moves them at its end."""
    head, mark, rest = GOOD.partition("    shape face,")
    shapes, use, tail = rest.partition("face dora")
    early, late = (
        "".join(f"    {row}\n" for row in rows if (row.split()[0] in LATE) is is_late) for is_late in (False, True)
    )
    return head + early + mark + shapes + late + use + tail


def made(*rows: str) -> Kind:
    kind = play_of(script(*rows)).faces[0].drawn
    assert kind is not None
    return kind


@pytest.mark.parametrize("name", kind_names())
def test_kinds_of_the_library_are_whole(name: str) -> None:
    kind = library_kind(name)
    assert kind.name == name and kind.shapes and kind.pulls
    assert kind.head == library_head(name)


def test_points_may_go_on_after_a_comma() -> None:
    one = made("shape nose, in nose, law nose, fill skin.base, outline (0 0) (10 4), (0 8 sharp), (-4 4 z 1.2)")
    (outline,) = one.shapes[-1].outlines
    assert [point.numbers for point in outline.points] == [(0, 0), (10, 4), (0, 8), (-4, 4)]
    assert [point.sharp for point in outline.points] == [False, False, True, False]
    assert [point.depth for point in outline.points] == [None, None, None, 1.2]


def test_fills_are_tones_and_gradients_of_tones() -> None:
    rows = (
        "skin.base", "#AABBCC", "skin.base 45% line.base", "down (skin.base at 0%) (#ffffff at 100% opacity 20%)",
        "round 40% 50% 70% (skin.base 10% line.base at 0%) (line.base at 100%)",
    )  # fmt: skip
    fills = [made(f"shape nose, in nose, law nose, fill {row}, spot (0 0 4 4)").shapes[-1].fill for row in rows]
    assert [fill.form for fill in fills] == ["plain", "plain", "plain", "line", "round"]
    assert fills[1].stops[0].tone.name == "#aabbcc"
    assert (fills[2].stops[0].tone.other, fills[2].stops[0].tone.share) == ("line.base", 0.45)
    assert (fills[3].stops[1].at, fills[3].stops[1].opacity) == (1.0, 0.2)
    assert fills[4].where == (0.4, 0.5, 0.7)


def test_a_muscle_moves_by_offsets_or_by_fields() -> None:
    kind = made(
        "muscle cheek.lower, each side, moves face, at (60 40) by (2 -5) within 50, at (20 60) by (0 -1) within 20",
        "muscle chin, moves face, by (0 -4)",
    )
    fields, offset = kind.pulls
    assert fields.sides and [field.within for field in fields.fields] == [50, 20]
    assert offset.by == ((0, -4),) and not offset.sides


@given(st.integers(3, 9), st.sampled_from(["outline", "half", "stroke", "spot", "disc"]), st.booleans())
def test_as_many_anchors_are_counted_as_are_drawn(count: int, form: str, pointed: bool) -> None:
    """Offsets are written one for each anchor: the reader must know how many the rig makes."""
    numbers = {"outline": "", "half": "", "stroke": " 0.01" if pointed else " 4", "spot": " 3 3", "disc": " 3 3"}[form]
    points = " ".join(f"({3 * k} {k * k}{numbers})" for k in range(count if numbers in ("", " 4", " 0.01") else 1))
    points = points.replace(" 0.01", " 4").replace(" 4)", " 0.01)", 1) if pointed and form == "stroke" else points
    (outline,) = made(f"shape nose, in nose, law nose, fill skin.base, {form} {points}").shapes[-1].outlines
    loop, depths = outlined(outline)
    assert len(loop) == anchors(outline) == len(depths)


@pytest.mark.parametrize(
    ("row", "code"),
    [
        ("shape nose, in nose, law nose, fill skin.base, outline (0 0) (1 1)", "FS241"),
        ("shape nose, in nose, law nose, fill skin.base, stroke (0 0 0) (1 1 2)", "FS241"),
        ("shape nose, in nosse, law nose, fill skin.base, spot (0 0 1 1)", "FS242"),
        ("shape nose, in nose, law nos, fill skin.base, spot (0 0 1 1)", "FS242"),
        ("shape nose, in nose, law nose, fill skin.bse, spot (0 0 1 1)", "FS242"),
        ("shape nose, in nose, law nose, fill down (skin.base at 0%), spot (0 0 1 1)", "FS241"),
        ("shape nose, in nose, law nose, fill skin.base, opacity 120%, spot (0 0 1 1)", "FS241"),
        ("shape nose, in nose, law nose, fill skin.base, clip nobody, spot (0 0 1 1)", "FS242"),
        ("shape nose, in nose, law nose, fill skin.base, spot (0 0 9000 1)", "FS243"),
        ("shape face, in nose, law nose, fill skin.base, spot (0 0 1 1)", "FS208"),
        ("shape eye-rim, each side, in eye, fill skin.base", "FS244"),
        ("shape mouth-muzzle, fill skin.base", "FS244"),
        ("mouth y 111, muzzle 0 10 26 20 62", "FS241"),
        ("shape eye-pupil, each side, fill #000000, spot (0 0 1 1)", "FS245"),
        ("muscle smile, moves face, by (0 1)", "FS242"),
        ("muscle chin, moves nobody, by (0 1)", "FS242"),
        ("muscle chin, moves face", "FS241"),
        ("muscle chin, moves face, at (0 0) by (1 1) within 0", "FS241"),
        ("shade face, chin", "FS241"),
        ("shade nobody, chin 50%", "FS242"),
        ("has wings", "FS242"),
        ("look trousers short, long", "FS242"),
        ("colours skin.base red", "FS241"),
        ("eye half-width 3", "FS244"),
        ("look", "FS241"),
        ("tints", "FS241"),
        ("jaw from 62, drop 0", "FS241"),
        ("shell 0 1", "FS241"),
    ],
)
def test_a_fault_is_told_at_its_row_and_nothing_else_is(row: str, code: str) -> None:
    play, diagnostics = resolved(script(row))
    assert play is None
    assert [item.code for item in diagnostics] == [code]
    span = diagnostics.items[0].span
    assert span is not None and span.text in row


def test_offsets_fit_the_shape_of_every_choice() -> None:
    rows = (
        "look eyebrows usual, bold",
        "shape one, in brow, law brow, when eyebrows usual, fill skin.base, outline (0 0) (9 0) (0 9)",
        "shape one, in brow, law brow, when eyebrows bold, fill skin.base, outline (0 0) (9 0) (9 9) (0 9)",
        "muscle chin, moves one, by (0 1) (0 2) (0 3)",
    )
    play, diagnostics = resolved(script(*rows))
    assert play is None
    assert [item.code for item in diagnostics] == ["FS247"]


def test_feature_points_are_all_there_or_none_is() -> None:
    play, diagnostics = resolved(script("point hairline (0 -100)"))
    assert play is None and [item.code for item in diagnostics] == ["FS244"]
    assert "`point temple`" in diagnostics.items[0].message and "23 points in `locks`" in diagnostics.items[0].message


def test_eyes_are_apart() -> None:
    assert [item.code for item in resolved(script().replace("eyes 100 apart", "eyes 0 apart"))[1]] == ["FS241"]


def test_a_faulty_kind_spoils_no_other_face() -> None:
    text = GOOD.replace("law contour", "law contur") + "face ada = woman\nada: nod\n"
    _, diagnostics = resolved(text)
    assert [item.code for item in diagnostics] == ["FS242"]
