"""Pages: what is packed is what the stage draws, text cannot break out, nothing is fetched, templates are filled."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from lxml import html

from facescript.backends.captions.cues import cues
from facescript.backends.captions.said import said
from facescript.backends.job import Job
from facescript.backends.page.document import page
from facescript.backends.page.motion import RATE, motion
from facescript.backends.page.packing import packed, unpacked
from facescript.backends.page.wish import PageWish
from facescript.backends.page.words import lines
from facescript.cli.main import main
from facescript.compile import compile_source
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

HOSTILE = "</script><script>alert(1)</script><img src=x onerror=alert(2)>"
TAG = "</p></script><img src=x>"
SCRIPT = f"""\
film 320x180, 10fps, seed 5, title "{HOSTILE}"
background #204060 to #f0d080, towards 90deg
face ada = woman, voice en-us
face rex = dog, voice he
scene one:
    together:
        ada: say "<b>Up</b> {TAG} &."
        view ada 180% over 300ms
        rex: say "שלום (a)."
scene two with rex:
    rex: nod for 200ms
"""


def job_of(text: str, **wish: object) -> Job:
    world = World(Path())
    compiled = compile_source(Source("talk.face", text), world, EstimatedVoice())
    assert compiled.play is not None and compiled.score is not None, [item.message for item in compiled.diagnostics]
    job = Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration)
    return replace(job, page=PageWish(**wish))  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def job() -> Job:
    return job_of(SCRIPT)


@pytest.fixture(scope="module")
def text(job: Job) -> str:
    return page(job).text


def test_numbers_come_back() -> None:
    rows = np.random.default_rng(1).integers(-(2**29), 2**29, (3, 50))
    assert (unpacked(packed(rows), 3) == rows).all()


def test_points_are_within_half_a_pixel_each_time(job: Job, text: str) -> None:
    moved = motion(job)
    assert moved.parts[0].rows in text, "the same each time"
    drawn = job.stage.frames(np.minimum(np.arange(moved.frames) / RATE, job.end))
    part = moved.parts[0]
    rows = unpacked(part.rows, sum(part.ways) + 2 * len(job.stage.shapes) + 3).T
    worst, at = 0.0, 0
    for basis, ways, first in zip(moved.bases, part.ways, moved.firsts, strict=True):
        ours = basis.points(rows[:, at : at + ways])
        count, at = ours.shape[1], at + ways
        seen = np.zeros(drawn.points.shape[:2], dtype=bool)
        for number, shape in enumerate(job.stage.shapes):
            for each in shape.contours:
                seen[:, each.first : each.first + each.count] |= drawn.opacity[:, number, None] > 0
        placed = ours * drawn.views[:, None, :1] + drawn.views[:, None, 1:]
        off = np.linalg.norm(placed - drawn.points[:, first : first + count], axis=2)
        worst = max(worst, float(off[seen[:, first : first + count]].max()))
    assert worst < 0.5
    shades = rows[:, at : at + len(job.stage.shapes)] / 255
    assert np.abs(shades - drawn.opacity).max() < 2 / 255


def test_hostile_text_stays_text(text: str, job: Job) -> None:
    tree = html.fromstring(text)
    assert len(tree.xpath("//script[not(@type)]")) == 1, "one script runs, which is ours"
    assert not tree.xpath("//img | //*[@onerror] | //b")
    assert tree.xpath("string(//title)") == HOSTILE
    said = [" ".join(line.text_content().split()) for line in tree.find_class("fs-line")]
    assert f"<b>Up</b> {TAG} &." in said[0]
    assert [line.get("lang") for line in tree.find_class("fs-line")] == ["en-US", "he"]
    assert [bdi.getparent().get("class") for bdi in tree.iter("bdi")] == ["fs-line", "fs-line"]


def test_nothing_is_fetched(text: str) -> None:
    rule = html.fromstring(text).xpath("string(//meta[@http-equiv='Content-Security-Policy']/@content)")
    assert "default-src 'none'" in rule and "http" not in rule
    for address in html.fromstring(text).xpath("//@src | //@href"):
        assert address.startswith(("data:", "#")), address


def test_words_have_their_times(text: str, job: Job) -> None:
    words = html.fromstring(text).find_class("fs-word")
    times = [float(word.get("data-start")) for word in words]
    spoken = [(line.start + word.start, word.text) for line in job.score.lines for word in line.spoken.words]
    assert len(spoken) == len(words)
    assert times == pytest.approx([start for start, _ in spoken], abs=0.001)
    stretch = lines(job.score, 0.1, 0.5)
    assert all(0 <= word.start < word.end <= 0.4 for line in stretch for word in line.words)


def test_captions_of_a_page_begin_where_those_of_a_file_do() -> None:
    text = (
        "Well, if the weather holds we shall walk along the river to the old mill. Yes! " * 3
        + "你好,世界。今天天气很好。"
    )
    job = job_of(f'face ada = woman, voice en-us\nada: say "{text}"\n')
    marked = html.fromstring(page(job).text).xpath("//*[@data-cue]/@data-start")
    found = cues(said(job.score, 0, 1e9))
    assert len(found) == 4
    assert [float(start) for start in marked] == pytest.approx([cue.start for cue in found], abs=0.001)


def test_faces_come_and_go_and_may_be_none(job: Job, text: str) -> None:
    film = json.loads(html.fromstring(text).get_element_by_id("facescript-film").text_content())
    assert film["cuts"] == [int(np.ceil(job.score.scenes[1].start * RATE - 1e-9))]
    heard = page(job_of('face ada = unseen, voice en-us\nada: say "Nobody."\n')).text
    assert "Nobody" in heard


def test_a_script_stands_in_its_page_as_it_is() -> None:
    made = page(job_of(SCRIPT, template="script", script=SCRIPT + "# {{title}}\n")).text
    (shown,) = html.fromstring(made).xpath("//pre")
    assert shown.text == SCRIPT + "# {{title}}\n"


def test_a_template_of_ones_own_and_parts_beside(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / "logo.svg").write_text("<svg/>", "utf-8")
    (tmp_path / "mine.html").write_text("<h1>{{ title }}</h1>{{face}}<img src='logo.svg'>", "utf-8")
    (tmp_path / "walk.face").write_text('film 64x64\nsay "Hi."\n', "utf-8")
    before = set(tmp_path.iterdir())
    build = ["build", "walk.face", "--quiet", "--split", "--page", "mine.html"]
    assert main([*build, "-o", "no/walk.html"]) == 1
    assert main([*build, "-o", "walk.csv"]) == 2
    assert set(tmp_path.iterdir()) == before, "nothing stays of a build that fails"
    assert main([*build, "-o", "walk.html"]) == 0
    assert sorted(path.name for path in (tmp_path / "walk-files").iterdir()) == ["0.js", "sound.webm"]
    text = (tmp_path / "walk.html").read_text("utf-8")
    assert "<h1>Walk</h1>" in text
    assert "img src='data:image/svg+xml;base64," in text
    assert not html.fromstring(text).find_class("fs-controls")
