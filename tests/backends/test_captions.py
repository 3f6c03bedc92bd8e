"""Captions: cut where they can be read, timed as the words are said, in files and in the frames of films."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.backends.captions.cues import BETWEEN, LINES, LONGEST, WIDEST, cues, joined
from facescript.backends.captions.fonts import font_for
from facescript.backends.captions.said import Said, Token, columns, said
from facescript.backends.captions.titles import Titles
from facescript.backends.captions.writing import write_srt, write_vtt
from facescript.backends.film import write_gif
from facescript.backends.frames import film_planes, pictures, planes
from facescript.backends.job import Job, JobFailure
from facescript.cli.main import main
from facescript.compile import compile_source
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.timing.files import read_times
from facescript.text import Source
from facescript.world import World

SCRIPT = """\
film 320x180, 10fps, seed 3
face ada = woman
face bruno = man

scene one:
    ada: say "Good evening, “everyone”! I have lost my cup, and nobody in this house (not the cat) has seen it."
    bruno: say "你好<世界>，再见。"
    bruno: say "Yes & no."
"""


def job_of(text: str, **changes: object) -> Job:
    world = World(Path(__file__).parent)
    compiled = compile_source(Source("test.face", text), world, EstimatedVoice())
    assert compiled.play is not None and compiled.score is not None, compiled.diagnostics.items
    job = Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration)
    return replace(job, **changes)  # type: ignore[arg-type]


def written(job: Job, folder: Path, kind: str) -> str:
    {"vtt": write_vtt, "srt": write_srt}[kind](job, folder / f"out.{kind}")
    return (folder / f"out.{kind}").read_text("utf-8")


# ------------------------------------------------------------------------------------ what a caption holds


def texts(text: str) -> list[tuple[str, ...]]:
    return [cue.texts for cue in cues(said(job_of(f'say "{text}"\n').score, 0, 1e9))]


def test_captions_end_with_sentences_and_lines_where_the_sense_is() -> None:
    assert texts("I have lost my cup, and nobody in this large house, not even the cat, has seen it. Have you?") == [
        ("I have lost my cup,", "and nobody in this large house,"),
        ("not even the cat, has seen it. Have you?",),
    ]
    assert texts("Yes. No! Maybe?") == [("Yes. No! Maybe?",)]


def test_signs_and_addresses_stay_with_their_words() -> None:
    assert texts("¿Qué (tal)? «Bien» — https://example.org/a?b=1, 3.5 %!") == [
        ("¿Qué (tal)? «Bien» —", "https://example.org/a?b=1, 3.5 %!"),
    ]


def test_chinese_counts_double_and_is_cut_at_its_signs() -> None:
    found = texts(
        "各位观众晚上好，今天是十月一日，星期二，欢迎收看新闻联播节目，今天节目的主要内容有：全国各地举行庆祝活动。"
    )
    assert all(columns(line) <= WIDEST for lines in found for line in lines)
    assert all(lines[-1][-1] in "，：。" for lines in found) and "".join("".join(lines) for lines in found)[-1] == "。"


LETTERS = ("a", "cup,", "everyone.", "世", "supercalifragilistic")


@settings(max_examples=30, deadline=None)
@given(
    words=st.lists(st.tuples(st.sampled_from([*LETTERS]), st.integers(1, 20)), min_size=1, max_size=60),
    start=st.floats(0, 5),
)
def test_every_word_is_shown_while_it_is_said_and_fits(words: list[tuple[str, int]], start: float) -> None:
    tokens = []
    at = start
    for text, tenths in words:
        tokens.append(
            Token(text, 0, at, at + tenths / 10, text != "世", 2 if text[-1] == "." else int(text[-1] == ","))
        )
        at += tenths / 10 + (1.0 if tenths == 7 else 0.0)
    found = cues([Said("ada", "en", tuple(tokens))])
    assert [token for cue in found for line in cue.lines for token in line] == tokens
    for cue, following in zip(found, [*found[1:], None], strict=True):
        shown = [token for line in cue.lines for token in line]
        assert len(cue.lines) <= LINES and all(columns(joined(line)) <= WIDEST for line in cue.lines)
        assert cue.start == shown[0].start and cue.end >= shown[-1].end - 1e-9
        assert shown[-1].end - shown[0].start <= LONGEST or len(shown) == 1
        if following is not None:
            assert cue.end <= following.start + 1e-9
            assert shown[-1].end > following.start - BETWEEN or following.start - cue.end > BETWEEN - 1e-9


# ------------------------------------------------------------------------------------ files


def test_vtt_names_faces_and_can_be_read_back(tmp_path: Path) -> None:
    job = job_of(SCRIPT, captions="words")
    text = written(job, tmp_path, "vtt")
    assert "<v ada>Good <00:00:00." in text and "<v bruno>你<" in text and "&lt;" in text and "Yes &amp; <" in text
    back = read_times("out.vtt", text.encode())
    for line in job.score.lines:
        for word in line.spoken.words:
            same = [other for other in back.words if other.text == word.text]
            assert min(abs(other.start - line.start - word.start) for other in same) < 0.002, word


def test_srt_names_a_face_where_it_speaks_after_another(tmp_path: Path) -> None:
    text = written(job_of(SCRIPT), tmp_path, "srt")
    assert text.startswith("1\n00:00:00,000 --> ") and text.count("bruno: ") == 1 and text.count("ada: ") == 1
    assert "bruno: 你好<世界>，再见。\n" in text
    assert written(job_of(SCRIPT, captions="words"), tmp_path, "srt").count("-->") == 27


def test_only_what_is_asked_for_is_captioned(tmp_path: Path) -> None:
    whole = job_of(SCRIPT)
    line = whole.score.lines[0]
    cut = replace(
        whole, start=line.start + line.spoken.words[2].start - 0.01, end=line.start + line.spoken.words[6].start
    )
    text = written(cut, tmp_path, "vtt")
    assert text.splitlines()[3] == "“everyone”! I have lost" and text.splitlines()[2].startswith("00:00:00.010 -->")
    assert text.count("-->") == 1
    assert written(replace(whole, end=0.01, start=0.0), tmp_path, "vtt").count("-->") == 1


def test_a_line_without_words_is_captioned_by_its_length(tmp_path: Path) -> None:
    job = job_of('say "One two. Three four five six seven eight nine."\n')
    line = job.score.lines[0]
    bare = replace(line, spoken=replace(line.spoken, words=()))
    text = written(replace(job, score=replace(job.score, lines=(bare,))), tmp_path, "vtt")
    assert "One two. Three four five\nsix seven eight nine." in text


# ------------------------------------------------------------------------------------ burned

SHORT = """\
film 320x180, 10fps, seed 3
face ada = woman
    life still
say "Good evening, everyone. I have lost my cup, and nobody in this house (not even the cat) has seen it."
wait 2s
"""


@pytest.fixture(scope="module")
def burned() -> Job:
    return job_of(SHORT, captions="burn")


@pytest.fixture(scope="module")
def plain(burned: Job) -> Job:
    return replace(burned, captions="sentences")


def test_burned_frames_are_the_frames_with_a_plate_and_letters(burned: Job, plain: Job) -> None:
    times = np.array([0.3, 0.9, 3.0, burned.score.duration - 0.5])
    titles = Titles(burned.score, 0, burned.score.duration, None)
    for time, seen, without in zip(times, pictures(burned.stage, times), pictures(plain.stage, times), strict=True):
        differs = (seen != without).any(axis=2)
        boxes = [sticker.box for sticker in titles.at(float(time))]
        assert differs.any() == bool(boxes) == (time < 5)
        for box in boxes:
            assert box.left >= 0 and box.right <= 320 and box.top > 90 and box.bottom < 172
            assert (box.of(seen) > 200).all(axis=2).sum() > 20 and (box.of(seen)[..., :3] < 90).all(axis=2).sum() > 200
            box.of(differs)[...] = False
        assert not differs.any()


def test_films_planes_are_those_of_single_frames_whatever_draws_them(burned: Job) -> None:
    times = np.arange(0.5, 3.9, 0.1)
    alone = [frame.copy() for frame in planes(burned.stage, times)]
    with film_planes(burned.stage, times, 2) as frames:
        assert all((frame == other).all() for frame, other in zip(frames, alone, strict=True))
    for number in (3, 13, 31):
        assert (next(planes(burned.stage, times[number : number + 1])) == alone[number]).all(), number


def test_nothing_of_a_caption_stays_behind(burned: Job, plain: Job) -> None:
    times = np.array([0.5, burned.score.duration - 0.2])
    *_, last = planes(burned.stage, times)
    assert (last == next(planes(plain.stage, times[1:]))).all()


def test_clear_grounds_have_captions_too(tmp_path: Path) -> None:
    job = job_of('film 160x90, 5fps, 1s long\nbackground none\n\nsay "Good evening."\n', captions="burn")
    write_gif(job, tmp_path / "out.gif")
    (frame,) = (picture.copy() for picture in pictures(job.stage, np.array([0.5])))
    box = Titles(job.score, 0, 9, None).at(0.5)[0].box
    corner = frame[box.top + box.bottom >> 1, box.left + 2]
    assert corner[3] > 150 and (corner[:3] <= corner[3]).all()


def test_signs_that_no_font_has_are_told() -> None:
    with pytest.raises(JobFailure, match=r"has the signs `\U00013000`"):
        font_for(["\U00013000"], None)
    with pytest.raises(JobFailure, match="no font"):
        font_for(["a"], b"nonsense")


def test_words_from_right_to_left_are_drawn() -> None:
    job = job_of('film 320x180\n\nsay "שלום לכולם"\n', captions="burn")
    try:
        (sticker,) = Titles(job.score, 0, 9, None).at(0.5)
    except JobFailure:
        pytest.skip("no font with Hebrew letters here")
    assert (sticker.alpha > 230).sum() > 20


def test_command_line_takes_what_fits(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    script = tmp_path / "a.face"
    script.write_text('film 64x36, 5fps\n\nsay "Hi."\n', "utf-8")
    assert main(["build", str(script), "-o", str(tmp_path / "a.mp4"), "--captions", "words"]) != 0
    assert main(["build", str(script), "-o", str(tmp_path / "a.vtt"), "--captions", "burn"]) != 0
    assert main(["build", str(script), "-o", str(tmp_path / "a.vtt"), "--captions", "loud"]) != 0
    assert main(["build", str(script), "-o", str(tmp_path / "a.vtt"), "--font", "x.ttf"]) != 0
    assert main(["build", str(script), "-o", str(tmp_path / "a.png"), "--captions", "burn", "--font", "x.ttf"]) != 0
    script.write_text('film 64x36, 5fps\n\nsay "Hi 𓀀."\n', "utf-8")
    assert main(["build", str(script), "-o", str(tmp_path / "a.mp4"), "--captions", "burn", "--quiet"]) != 0
    told = capsys.readouterr().err
    assert told.count("FS907") == 1 and "`𓀀`" in told
    assert told.count("FS905") == 3 and told.count("FS904") == 1 and told.count("FS901") == 1
