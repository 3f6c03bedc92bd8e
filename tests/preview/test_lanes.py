"""What the timeline is told: bars, their rows and places, words; and the curves it asks for."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facescript.backends.job import Job
from facescript.compile import Compiled, compile_source
from facescript.plot.acts import Bar
from facescript.preview.curves import EVERY, curves
from facescript.preview.lanes import MOST_ROWS, rows, timeline
from facescript.preview.places import Units
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.web.messages import head_of
from facescript.world import World

SCRIPT = """\
film 30fps, title "Tea 🍵"
let warm = 60%
face ada = woman
    life conversation
face bruno = man, voice en-gb
action greet(who):
    look at who, eyes then head
scene tea:
    ada: say "Where is my *cup*?" as hello
        "Here it is."
        on "cup": nod 30%
    bruno: greet ada
    ada: show smile warm for 2s
    ada: show frown 40%
scene more with bruno:
    bruno: blink
"""


def compiled(text: str, folder: Path | None = None) -> Compiled:
    source = Source("tea.face", text)
    world = World(folder or Path())
    return compile_source(source, world, EstimatedVoice(world))


def told(text: str, folder: Path | None = None) -> dict[str, Any]:
    made = compiled(text, folder)
    assert made.play is not None and made.score is not None, [item.message for item in made.diagnostics]
    found: dict[str, Any] = timeline(made.score, made.play, made.source, Units(text))
    json.dumps(found, allow_nan=False)
    return found


@pytest.fixture(scope="module")
def tea() -> dict[str, Any]:
    return told(SCRIPT)


def acts(found: dict[str, Any], face: str | None, lane: str) -> list[dict[str, Any]]:
    number = next(index for index, each in enumerate(found["lanes"]) if (each["face"], each["name"]) == (face, lane))
    return [act for act in found["acts"] if act["lane"] == number]


def statement(act: dict[str, Any], text: str = SCRIPT) -> str:
    units = text.encode("utf-16-le")
    return units[2 * act["from"] : 2 * act["to"]].decode("utf-16-le")


def test_lanes_are_those_of_the_plot(tea: dict[str, Any]) -> None:
    names = [(lane["face"], lane["name"]) for lane in tea["lanes"]]
    assert names[0] == (None, "scene")
    assert [name for face, name in names if face == "ada"] == ["face", "gesture", "speech", "life"]
    assert [name for face, name in names if face == "bruno"] == ["gaze", "gesture", "life"]
    assert len({lane["colour"] for lane in tea["lanes"]}) == 6


def test_an_act_is_bound_to_its_statement_in_utf_16(tea: dict[str, Any]) -> None:
    (line,) = acts(tea, "ada", "speech")
    assert statement(line) == 'say "Where is my *cup*?" as hello\n        "Here it is."'
    assert [statement(act) for act in acts(tea, "ada", "face")] == ["show smile warm for 2s", "show frown 40%"]
    assert statement(acts(tea, "ada", "life")[0]) == "face ada = woman"
    assert line["line"] == SCRIPT[: SCRIPT.index("say")].count("\n") + 1
    assert not line["estimated"] and acts(tea, "ada", "face")[0]["estimated"]
    assert all("from" not in act for act in acts(tea, None, "scene"))


def test_an_act_of_a_used_file_names_the_file(tmp_path: Path) -> None:
    (tmp_path / "moves.face").write_text("action bow:\n    nod 80%\n", "utf-8")
    (nod,) = acts(told('use "moves.face"\nbow\n', tmp_path), "somebody", "gesture")
    assert (nod["file"], nod["line"]) == ("moves.face", 2) and "from" not in nod


def test_a_recorded_face_is_a_bar_of_what_a_face_shows(tmp_path: Path) -> None:
    (tmp_path / "take.csv").write_text("time,lid.left\n0,0\n1,1\n", "utf-8")
    (take,) = acts(told('play "take.csv" for 1.5s\n', tmp_path), "somebody", "face")
    assert (take["start"], take["apex"], take["release"], take["end"]) == (0.0, 0.2, 1.5, 1.7)
    assert take["label"] == 'play "take.csv"'


def test_bars_say_when_they_come_and_go(tea: dict[str, Any]) -> None:
    smile, frown = acts(tea, "ada", "face")
    assert smile["start"] < smile["apex"] <= smile["release"] <= smile["end"]
    assert smile["settled"] == pytest.approx(smile["start"] + 2, abs=1e-3) and frown["start"] == smile["settled"]
    assert smile["row"] == frown["row"] == 0


def test_words_are_those_that_are_heard(tea: dict[str, Any]) -> None:
    (line,) = tea["lines"]
    assert [word["text"] for word in line["words"]] == ["Where", "is", "my", "cup", "Here", "it", "is"]
    starts = [word["start"] for word in line["words"]]
    assert starts == sorted(starts) and line["start"] <= starts[0] and line["words"][-1]["end"] <= line["end"]
    assert tea["markers"][0]["name"] == "tea.hello" and [scene["name"] for scene in tea["scenes"]] == ["tea", "more"]
    assert "gaze.yaw" in tea["channels"]["ada"] and "ear.left" not in tea["channels"]["ada"]


@given(st.lists(st.tuples(st.floats(0, 9), st.floats(0, 5), st.floats(0, 1)), max_size=40))
def test_bars_of_a_row_follow_one_another(shapes: list[tuple[float, float, float]]) -> None:
    bars = [Bar(start, start, start + long, start + long + tail, "", "") for start, long, tail in sorted(shapes)]
    found = list(rows(bars))
    assert all(0 <= row < MOST_ROWS for row in found)
    for row in range(MOST_ROWS - 1):
        mine = [bar for bar, number in zip(bars, found, strict=True) if number == row]
        assert all(one.release <= other.start for one, other in pairwise(mine))


def test_curves_are_the_performance() -> None:
    made = compiled(SCRIPT)
    assert made.play is not None and made.score is not None
    job = Job(made.play, made.score, lambda name: b"", 0.0, made.score.duration)
    asked = {"face": "ada", "channels": ["lid.left", "head.yaw", "nonsense", 7, "ear.left", "lid.left"]}
    found: Any = head_of(curves(job, 3, asked))
    yaw, lid = found["channels"]
    assert found["version"] == 3 and [lid["name"], yaw["name"]] == ["lid.left", "head.yaw"]
    assert [lid["unit"], yaw["unit"]] == ["1", "deg"]
    times = np.arange(len(yaw["values"])) * EVERY
    assert times[-1] <= made.score.duration < times[-1] + EVERY
    column = job.performance.names.index("ada.head.yaw")
    assert yaw["values"] == pytest.approx(job.performance.sample(times)[:, column].tolist(), abs=0.006)
    assert yaw["least"] == min(yaw["values"]) and yaw["most"] == max(yaw["values"])
    for nonsense in ({"face": "nobody", "channels": ["lid.left"]}, {"face": ["ada"], "channels": {}}, {}):
        assert head_of(curves(job, 3, nonsense))["channels"] == []


def test_the_end_of_a_change_is_when_it_is_done() -> None:
    found = told("life calm over 2s\nwait 3s\ndrop smile over 1s\n".replace("drop", "show smile\ndrop"))
    change, drop = acts(found, "somebody", "life")[-1], acts(found, "somebody", "face")[-1]
    assert change["until"] == pytest.approx(2.0) and change["end"] > 4
    assert drop["until"] == pytest.approx(drop["start"] + 1.0)
