"""What a run tells of: marks, each once and in time, and lines before they sound."""

from __future__ import annotations

from running import FPS, running

from facescript.live.model import Happening, Mark, Utterance
from facescript.live.run.run import Run

TALK = """face ada = woman
    life still
scene main:
    repeat forever:
        say "one two three four five" as count
        wait 2s
when heard "no":
    say "wait" as hold
"""


def told(run: Run, seconds: float) -> tuple[list[Mark], list[tuple[float, Utterance]]]:
    """All marks, and the utterances with the time at which each was told of."""
    marks: list[Mark] = []
    spoken: list[tuple[float, Utterance]] = []
    for number in range(int(seconds * FPS)):
        time = run.frame(number).time
        marks += run.marks(time)
        spoken += ((time, utterance) for utterance in run.utterances(time))
    return marks, spoken


def test_marks_come_once_and_in_time() -> None:
    marks, _ = told(running(TALK, [Happening("heard", 0.6, "no")]), 6.0)
    assert [mark.time for mark in marks] == sorted(mark.time for mark in marks)
    assert len(set(marks)) == len(marks)
    lines = [(mark.kind, mark.text, mark.label) for mark in marks if mark.kind in ("line", "breaks", "scene", "event")]
    assert lines[:7] == [
        ("scene", "main", None),
        ("line", "one two three four five", "main.1.count"),
        ("event", "heard no", None),
        ("breaks", "one two three four five", "main.1.count"),
        ("line", "wait", "when.1.hold"),
        ("line", "one two three four five", "main.1.count"),
        ("line", "one two three four five", "main.2.count"),
    ]
    said = [mark.text for mark in marks if mark.kind == "word"]
    assert said[:10] == ["one", "two", "three", "wait", "one", "two", "three", "four", "five", "one"]


def test_a_line_is_told_of_before_it_sounds_and_again_when_it_is_cut() -> None:
    _, spoken = told(running(TALK, [Happening("heard", 0.6, "no")]), 6.0)
    first, again, wait, count = (utterance for _, utterance in spoken[:4])
    assert (first.text, first.start, first.cut) == ("one two three four five", 0.0, None)
    assert again.number == first.number and again.cut is not None and 0.6 <= again.cut < 1.0
    assert wait.text == "wait" and wait.start == again.cut
    assert count.text == first.text and count.number not in (first.number, wait.number)
    assert all(time >= utterance.start - 0.5 for time, utterance in spoken)
    assert all(time <= utterance.start + 1 / FPS for time, utterance in spoken if utterance.cut is None)


def test_a_line_that_comes_to_nothing_is_taken_back() -> None:
    """An event half a second before a line is due takes the voice: the line is told of anew when it is known when."""
    text = TALK.replace("repeat forever:", "repeat forever:\n        wait 1s")
    _, spoken = told(running(text, [Happening("heard", 0.8, "no")]), 4.0)
    first, back, wait, again = (utterance for _, utterance in spoken[:4])
    assert (first.start, back.number, back.cut) == (1.0, first.number, 1.0)
    assert wait.text == "wait"
    assert again.text == first.text and again.start > wait.start


def test_an_event_before_the_last_frame_is_at_it() -> None:
    run = running(TALK)
    for number in range(60):
        run.frame(number)
    run.hear(Happening("heard", 0.1, "no"))
    run.frame(60)
    assert [(mark.kind, mark.time) for mark in run.marks(1.0) if mark.kind == "event"] == [("event", 59 / FPS)]


def test_more_than_can_be_solved_is_counted_and_the_face_goes_on() -> None:
    body = "    repeat 1000 times:\n        repeat 1000 times:\n            wait 0s\n"
    run = running(f'face ada = woman\nwait 1s\nwhen heard "no":\n{body}', [Happening("heard", 0.5, "no")])
    assert len([run.frame(number) for number in range(60)]) == 60
    assert run.doubts() == {"moments of more statements than can be solved": 1}


def test_a_long_scene_is_told_to_its_end() -> None:
    """Only some hundreds of statements are looked ahead; what stands beside them is done at its time wherever it is."""
    text = "face ada = woman\n    life still\n" + "wait 20ms\n" * 400 + "at 1s: nod\nshake as last\n"
    marks, _ = told(running(text), 9.0)
    done = [(mark.text.split()[0], round(mark.time, 3)) for mark in marks if mark.kind == "act"]
    assert done == [("nod", 1.0), ("shake", 8.0)]


def test_faces_that_are_only_heard_have_no_channels_but_lines() -> None:
    run = running('face narrator = unseen, voice en-gb\nscene main:\n    say "Good evening."\n', [])
    assert run.layout.names == () and run.frame(0).values.shape == (0,)
    marks, spoken = told(run, 1.0)
    assert [mark.text for mark in marks if mark.kind == "line"] == ["Good evening."] and len(spoken) == 1
