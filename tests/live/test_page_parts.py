"""What the page of a run is told: points as a film has them, hair that swings as a film's, lines, buttons; its port."""

from __future__ import annotations

import json
import socket
from dataclasses import replace
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from facescript.cli.main import main
from facescript.compile import Compiled, compile_source
from facescript.live.model import Frame, Layout, Utterance
from facescript.live.page.hair import HEAD, Trail
from facescript.live.page.lines import Lines, captions_of
from facescript.live.page.offer import offer
from facescript.live.page.picture import Picture
from facescript.live.page.scenery import Scenery
from facescript.motion.hair import STEP, Hair
from facescript.motion.perform import perform
from facescript.performance.channels import HAIR
from facescript.performance.performance import REST
from facescript.speech.estimate import EstimatedVoice
from facescript.stage.stage import Stage
from facescript.text import Source
from facescript.world import World

SCRIPT = """\
film 320x180, seed 2
background #204060
face ada = woman, hair still
face bruno = dog, at 30% 0%
scene one:
    ada: show smile over 200ms
    bruno: look left 20deg
    view ada 180%
    wait 200ms
scene two with bruno:
    background #204060 to #806020 over 400ms
    bruno: say "Good evening. Come in, and have a look around the old town hall of ours, it is open until five."
scene three with ada:
    wait 200ms
when touched "Start":
    ada: nod
when touched "The map":
    ada: nod
when touched "start!":
    ada: blink
when key "q":
    ada: blink
"""


@pytest.fixture(scope="module")
def made() -> Compiled:
    return compile_source(Source("made.face", SCRIPT), World(Path.cwd()), EstimatedVoice())


def numbers_of(message: bytes) -> tuple[dict[str, Any], bytes]:
    length = int.from_bytes(message[:4], "little")
    return json.loads(message[4 : 4 + length]), message[4 + length :]


def test_a_page_is_told_the_points_that_a_film_has(made: Compiled) -> None:
    assert made.score is not None and made.play is not None
    score, performance = made.score, perform(made.score)
    layout = Layout(60.0, tuple(performance.faces), performance.names, performance.channels)
    picture, scenery = Picture(made.play.film, made.play.faces), Scenery(score, layout, World(Path.cwd()).read)
    first, rest = numbers_of(next(picture.figure({})))
    at_rest = np.frombuffer(rest, "<f4")[: -len(first["shapes"])].reshape(2, -1)
    times = np.array([0.1, 0.3, 0.7, score.scenes[1].start + 0.3])
    film = Stage(score, performance, World(Path.cwd()).read).frames(times)
    scenes = [
        scenery.scene(Frame(number, time, performance.sample(times[number : number + 1])[0]), score)
        for number, time in enumerate(times.tolist())
    ]
    for number, (scene, row) in enumerate(zip(scenes, picture.draw([each.pose for each in scenes]), strict=True)):
        values, count = np.frombuffer(row, "<i2"), at_rest.shape[1]
        points = (at_rest + first["step"] * values[: 2 * count].reshape(2, -1)).T
        scale, *place = scene.head["view"]  # type: ignore[misc]
        shown = film.opacity[number] > 0
        for shape, seen in zip(first["shapes"], shown, strict=True):
            for start, size in shape["contours"] if seen else ():
                here = slice(start, start + size)
                assert np.abs(points[here] * scale + place - film.points[number, here]).max() < 0.05
        opacity = values[2 * count : 2 * count + len(shown)] / 255
        assert np.abs(opacity - film.opacity[number]).max() < 0.003


def test_what_is_cut_to_is_told(made: Compiled) -> None:
    """A face that is not there any more, and a view that changes at once; no other frame."""
    assert made.score is not None
    score, performance = made.score, perform(made.score)
    layout = Layout(60.0, tuple(performance.faces), performance.names, performance.channels)
    scenery, (_, two, three) = Scenery(score, layout, World(Path.cwd()).read), [each.start for each in score.scenes]
    view = next(act.start for act in score.acts if type(act.verb).__name__ == "View")
    seen = []
    for number, time in enumerate((0.0, 0.1, view + 0.01, two + 0.01, two + 0.03, three - 0.01, three + 0.01)):
        values = performance.sample(np.array([time]))[0]
        seen.append(scenery.scene(Frame(number, time, values), score).head["cuts"])
    assert np.diff(np.array(seen)).tolist() == [0, 1, 1, 0, 0, 1]


def test_hair_swings_as_in_a_film() -> None:
    times = np.arange(0, 2.0, STEP)

    def heads(at: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
        yaw = 25 * np.clip((at - 0.3) / 0.4, 0, 1)
        return np.stack([yaw, -0.3 * yaw, 0.1 * yaw, 0 * yaw, 0 * yaw], axis=1)

    film, trail, found = Hair(heads, [(0.0, 10.0)]).sample(times), Trail(), []
    for time, head in zip(times.tolist(), heads(times), strict=True):
        pose = REST.copy()
        pose[HEAD] = head
        trail.follow(pose, time)
        found.append(pose[-len(HAIR) :])
    assert np.abs(film).max() > 2
    # a film knows the push of the step that begins, a run only that of the step that is over
    assert np.abs(np.array(found)[1:] - film[:-1]).max() < 0.5


def test_a_line_is_told_once_and_then_where_it_breaks_off(made: Compiled) -> None:
    assert made.score is not None and made.play is not None
    line, lines = made.score.lines[0], Lines(made.play)
    said = Utterance(1, line.face, 5.0, line.spoken, 1.0, line.text)
    head, _ = numbers_of(lines.take(said))
    assert head["kind"] == "line" and head["name"] == "Bruno" and head["cut"] is None
    told = captions_of(said)
    assert len(told) >= 2 and " ".join(text for _, _, text in told) == line.text
    assert all(before[1] <= after[0] for before, after in pairwise(told))
    assert json.loads(lines.take(replace(said, cut=6.0))) == {"kind": "cut", "number": 1, "cut": 6.0}
    assert len(lines.sounding(5.5)) == 1 and not lines.sounding(6.5), "who comes later is told what still sounds"


def test_a_page_offers_what_the_script_waits_for(made: Compiled) -> None:
    assert made.play is not None
    offered = offer(made.play)
    assert offered.touched == ("Start", "The map") and offered.keys == ("q",)
    assert offered.happening("touched", "Stop") is None


def test_a_port_that_is_taken_is_told(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "x.face").write_text("nod\n", "utf-8")
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = str(taken.getsockname()[1])
        assert main(["live", str(tmp_path / "x.face"), "--page", port, "--for", "1s"]) == 2
        assert "FS982" in (told := capsys.readouterr().err) and port in told
    assert main(["live", str(tmp_path / "x.face"), "--page", "no"]) == 2
    assert "FS904" in capsys.readouterr().err
