"""What a plot shows of a script, and where."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path

import pytest
from plotting import curves, job_of, plot, points, texts, told

from facescript.plot.axis import Scale
from facescript.plot.channels import PlotFault
from facescript.plot.font import width
from facescript.plot.lanes import MOST_ROWS
from facescript.plot.marks import SMALL, Area, Line, Text
from facescript.plot.picture import LEFT, RIGHT, WIDTH
from facescript.plot.words import word_strip

GOLDEN = Path(__file__).parent / "golden"

SMALL_SCRIPT = """\
film screen none
face ada = woman
    life still
target lamp at 20deg 0deg 2m
look at lamp over 400ms
say "Here is the lamp"
    on "lamp": nod
show smile 60% over 400ms for 1s back in 300ms
"""

TWO = "face ada = woman\n    life still\nface bo = man\n    life still\n"
SOMEBODY = "face ada = woman\n    life still\n"


def test_small_script() -> None:
    """A golden list of the marks of a look, a line, a nod and a smile."""
    assert told(plot(SMALL_SCRIPT)) == (GOLDEN / "small.txt").read_text("utf-8")


def test_stretch_is_cut_at_the_edges() -> None:
    whole = plot(SMALL_SCRIPT, start=0.5, end=2.0, size=(900, 700))
    assert (whole.width, whole.height) == (900, 700)
    assert "0.5 s to 2 s of 2.9 s" in " ".join(texts(whole))
    for mark in whole.marks:
        assert all(0 <= x <= 900 and 0 <= y <= 700 for x, y in points(mark)), mark


def test_every_curve_keeps_to_its_stretch() -> None:
    drawn = [mark for mark in plot(SMALL_SCRIPT).marks if isinstance(mark, Line) and mark.name]
    assert {"head.yaw", "gaze.yaw", "eye.left.yaw eye.right.yaw", "mouth.open"} <= {mark.name for mark in drawn}
    for mark in drawn:
        places = points(mark)
        assert all(LEFT <= x <= WIDTH - RIGHT for x, _ in places)
        assert mark.name == "target" or [x for x, _ in places] == sorted(x for x, _ in places)


def test_each_face_has_its_block() -> None:
    drawing = plot(TWO + 'ada: look at bo\nbo: say "Yes"\nada: nod\n')
    heads = {mark.text: mark.y for mark in drawing.marks if isinstance(mark, Text) and mark.text in ("ada", "bo")}
    where = {mark.text: mark.y for mark in drawing.marks if isinstance(mark, Text) and mark.text in ("nod", "“Yes”")}
    assert heads["ada"] < where["nod"] < heads["bo"] < where["“Yes”"]
    assert curves(drawing).count("head.yaw") == 2


def test_one_face_needs_no_heading() -> None:
    assert "ada" not in texts(plot(SOMEBODY + "nod\n"))


def test_voice_alone_is_plotted() -> None:
    drawing = plot('face narrator = unseen\nsay "Once upon a time"\n')
    assert curves(drawing) == []
    assert {"“Once upon a time”", "Once", "time", "sound"} <= set(texts(drawing))
    with pytest.raises(PlotFault) as fault:
        plot('face narrator = unseen\nsay "Once"\n', "head.yaw")
    assert fault.value.code == "FS923"


def test_sides_that_are_equal_are_one_curve() -> None:
    both = curves(plot(SOMEBODY + "show smile\n"))
    assert "cheek.lower.left cheek.lower.right" in both and "cheek.lower.left" not in both
    one = curves(plot(SOMEBODY + "show smile.left\n"))
    assert "cheek.lower.left" in one and not any("cheek.lower.right" in name for name in one)


def test_channels_choose_faces_sides_and_panels() -> None:
    script = TWO + "ada: look left\nbo: blink\n"
    assert curves(plot(script, "head.yaw")) == ["head.yaw", "head.yaw"]
    assert curves(plot(script, "ada.head.yaw")) == ["head.yaw"]
    assert sorted(curves(plot(script, "ada.eye.yaw"))) == ["eye.left.yaw", "eye.right.yaw"]
    drawing = plot(script, "bo.lid", "bo.head.pitch", "bo.head.x", "bo.head.pitch")
    assert curves(drawing) == ["lid.left lid.right", "head.pitch", "head.x"]
    assert {"shares", "degrees", "cm"} <= set(texts(drawing)) and "ada" not in texts(drawing)


@pytest.mark.parametrize(
    ("name", "near"),
    [("head.jaw", "head.yaw"), ("bo.head.jaw", "bo.head.yaw"), ("lids", "lid"), ("nobody.head.yaw", None)],
)
def test_unknown_channel(name: str, near: str | None) -> None:
    with pytest.raises(PlotFault) as fault:
        plot(TWO + "ada: nod\n", name)
    assert fault.value.code == "FS920"
    assert fault.value.values["near"] == (f"; did you mean `{near}`?" if near else ".")


def test_a_channel_that_none_of_the_faces_has() -> None:
    for name in ("ear", "bo.ear.left"):
        with pytest.raises(PlotFault) as fault:
            plot(TWO + "ada: nod\n", name)
        assert fault.value.values["near"] == " of these faces; only these kinds have it: `dog`, `rodent`."


def test_a_size_that_cannot_hold_it() -> None:
    with pytest.raises(PlotFault) as fault:
        plot(SMALL_SCRIPT, size=(300, 200))
    wide, high = map(int, str(fault.value.values["least"]).split("x"))
    fitting = plot(SMALL_SCRIPT, size=(wide, high))
    assert max(y for mark in fitting.marks for _, y in points(mark)) <= high


def test_bars_say_when() -> None:
    drawing = plot(SOMEBODY + "show smile over 200ms for 1s back in 300ms\n", end=1.2)
    scale = Scale(LEFT, WIDTH - RIGHT, 0.0, 1.2)
    (bar,) = [mark for mark in drawing.marks if isinstance(mark, Area) and "show smile" in mark.note]
    assert bar.note == "show smile for 1s\nscript.face:3\n0.000 s to 1.300 s"
    assert [x for x, _ in bar.points] == pytest.approx([scale.x(time) for time in (0.0, 0.2, 1.0, 1.2)])


def test_looks_last_until_all_their_parts_are_taken() -> None:
    script = (
        SOMEBODY + "look left\nat 1s: look up, eyes only\nat 2s: look right, head only\nat 3s: look down\nwait 4s\n"
    )
    notes = [mark.note.split("\n") for mark in plot(script).marks if isinstance(mark, Area) and "look" in mark.note]
    spans = {note[0].split(",")[0]: note[2] for note in notes}
    assert spans["look left 20deg"].endswith("to 2.000 s")
    assert spans["look up 20deg"].endswith("to 3.000 s") and spans["look right 20deg"].endswith("to 3.000 s")


def test_what_is_dropped_ends_with_its_drop() -> None:
    script = SOMEBODY + "add AU1 as raised\nwait 1s\ndrop raised over 200ms\nwait 1s\n"
    (note,) = [mark.note for mark in plot(script).marks if isinstance(mark, Area) and mark.note.startswith("add AU1")]
    assert note.endswith("0.000 s to 1.600 s")


def test_acts_that_overlap_lie_below_one_another() -> None:
    script = SOMEBODY + "together:\n" + "".join(f"    add {unit} for 2s\n" for unit in ("AU1", "AU4", "AU6"))
    bars = [mark for mark in plot(script).marks if isinstance(mark, Area) and mark.note.startswith("add")]
    spans = [(min(y for _, y in bar.points), max(y for _, y in bar.points)) for bar in bars]
    assert len(bars) == 3
    assert all(one[1] <= other[0] or other[1] <= one[0] for one, other in combinations(spans, 2))


def test_acts_beyond_the_rows_are_counted() -> None:
    adds = "".join("    add AU1 5% for 2s\n" for _ in range(MOST_ROWS + 3))
    assert "face (+3)" in texts(plot(f"{SOMEBODY}together:\n{adds}"))


def test_events_scenes_and_views_have_lanes_of_their_own() -> None:
    drawing = plot(
        TWO + 'scene one:\n    wait 1s\nscene two:\n    view bo 150% over 500ms\n    ada: nod\n'
        'when heard "no":\n    ada: shake\nevent heard "no" at 500ms\n'
    )  # fmt: skip
    assert {"scene", "one", "two", "view", "bo 150%", "event", "heard “no”"} <= set(texts(drawing))


def test_words_never_overlap_and_those_left_out_are_counted() -> None:
    script = SOMEBODY + f'say "{" ".join(f"word{number}" for number in range(200))}"\n'
    lines, scale = job_of(script).score.lines, Scale(92.0, 1180.0, 0.0, 60.0)
    strip = word_strip(lines, scale)
    assert strip is not None and 20 < len(strip.words) < strip.count == 200
    _apart(strip.words)
    assert f"{len(strip.words)} of 200" in [
        mark.text for mark in strip.marks(scale, 0.0, 0.0) if isinstance(mark, Text)
    ]
    close = word_strip(lines, Scale(92.0, 1180.0, 0.0, 9.0))
    assert close is not None and len(close.words) == close.count == 30
    _apart(close.words)


def _apart(words: tuple[tuple[float, int, str], ...]) -> None:
    for (x, row, text), (other, beside, _) in combinations(words, 2):
        assert row != beside or x + width(text, SMALL) < other


def test_a_short_wild_movement_shows_in_a_long_film() -> None:
    """A blink of 200 ms in four minutes, less than a pixel wide, keeps its height."""
    drawing = plot(SOMEBODY + "wait 120s\nblink for 200ms\nwait 120s\n")
    (lid,) = [mark for mark in drawing.marks if isinstance(mark, Line) and mark.name == "lid.left lid.right"]
    ys = [y for _, y in points(lid)]
    assert max(ys) - min(ys) > 30
    assert len(ys) < 20, "what is still is one stroke"
