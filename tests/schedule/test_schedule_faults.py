"""What an author is told about times: the code, the places, and whether an estimate makes it a warning."""

from __future__ import annotations

import pytest
from scheduling import Metronome, Scheduled, scheduled

from facescript.diagnostics.catalogue.time import TIME
from facescript.diagnostics.model import Diagnostics, Severity
from facescript.ir.acts import Do, Life, Say, Sequence, Voice
from facescript.ir.play import Face, Film, Play, Scene
from facescript.schedule.scheduler import schedule
from facescript.speech.model import Spoken, VoiceFailure
from facescript.text import Source, Span


def places(done: Scheduled, code: str) -> list[tuple[str, list[str]]]:
    """The text of each diagnostic of a code, and of its other places."""
    found = [item for item in done.diagnostics if item.code == code]
    return [(item.span.text, [other.span.text for other in item.related]) for item in found if item.span]


@pytest.mark.parametrize("entry", [entry for entry in TIME if entry.stage != "unforced"], ids=lambda entry: entry.code)
def test_examples(entry: object) -> None:
    estimated = entry.stage == "check"  # type: ignore[attr-defined]
    assert set(scheduled(entry.bad, estimated).codes) == {entry.code}  # type: ignore[attr-defined]
    assert entry.code not in scheduled(entry.good, estimated).codes  # type: ignore[attr-defined]


def test_two_lines_show_both_places() -> None:
    done = scheduled('at 100ms: say "two words"\nsay "one"\n')
    assert done.score is None
    assert places(done, "FS403") == [('say "two words"', ['say "one"'])]


def test_two_lines_of_two_faces_are_no_conflict() -> None:
    done = scheduled('face a = woman\nface b = man\n\ntogether:\n    a: say "one"\n    b: say "one"\n')
    assert done.codes == []


@pytest.mark.parametrize(("estimated", "code"), [(True, "FS402"), (False, "FS403")])
def test_an_estimate_makes_a_conflict_a_warning(estimated: bool, code: str) -> None:
    done = scheduled('say "one two three"\nat 500ms: say "four"\n', estimated)
    assert done.codes == [code]
    assert (done.score is None) is not estimated


def test_lines_that_start_together_are_an_error_without_a_voice_too() -> None:
    done = scheduled('together:\n    say "one"\n    say "two"\n', estimated=True)
    assert [(item.code, item.severity) for item in done.diagnostics] == [("FS401", Severity.ERROR)]


def test_shows_that_start_together() -> None:
    done = scheduled("at 700ms: show surprise\nnod\nshow smile\n")
    assert places(done, "FS404") == [("show smile", ["show surprise"])]
    assert scheduled("together:\n    look at camera\n    look left 10deg\n").codes == []


def test_a_circle_is_shown_whole() -> None:
    done = scheduled("at three.end: nod as one\nat one.end: blink as two\nat two.start: shake as three\n")
    ((first, others),) = places(done, "FS405")
    shown = " ".join([first, *others])
    for name in ("one", "two", "three"):
        assert f"as {name}" in shown
    (message,) = [item.message for item in done.diagnostics]
    assert message.count("which waits for") == 3


def test_a_circle_through_the_sequence_itself() -> None:
    done = scheduled("wait until late.end\nnod as late\n")
    assert places(done, "FS405") == [("wait until late.end", ["nod as late"])]


def test_a_statement_that_waits_for_itself() -> None:
    assert scheduled("at me.end: nod as me\n").codes == ["FS405"]
    assert scheduled("at me.end - 2s: nod as me\nwait 1s\nwait until me.start\n").codes == ["FS405"]


def test_a_fault_is_told_once_however_often_it_is_played() -> None:
    done = scheduled("repeat 5 times:\n    nod\n    wait until 100ms\n")
    assert done.codes == ["FS406"]


def test_a_forward_reference_may_reach_as_far_as_it_likes() -> None:
    chain = "".join(f"at n{number + 1}.end: blink as n{number}\n" for number in range(1000))
    assert len(scheduled(f"{chain}nod as n1000\n").solved.acts) == 1001


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("repeat 1000 times:\n    repeat 1000 times:\n        repeat 1000 times: wait 0ms\n", "FS412"),
        ("film 1000s long\n\nrepeat forever: wait 1ms\n", "FS412"),
        ("film 10s long\n\nrepeat forever: wait 0ms\n", "FS410"),
        (f"target c of {' (0cm 0cm 1m)' * 300}\n\nscene s:\n    repeat 100 times: scan c, 100ms each\n", "FS412"),
        ("repeat for 10s:\n    repeat 2 times: background #101010\n", "FS410"),
    ],
)
def test_nothing_hangs(text: str, code: str) -> None:
    assert scheduled(text).codes == [code]


def test_a_forever_inside_a_repeat_for_is_bounded() -> None:
    done = scheduled("repeat for 3s:\n    repeat forever:\n        nod\n")
    assert len(done.solved.acts) == 5
    assert done.solved.duration == pytest.approx(3.5)


def test_what_the_film_cuts_is_told_once() -> None:
    done = scheduled("film 2s long\n\nnod\nwait 2s\nnod\nshake\n")
    assert done.codes == ["FS414"]
    assert len(done.solved.acts) == 1
    assert scheduled("film 2s long\n\nrepeat forever:\n    nod\n    wait 100ms\n").codes == []
    assert scheduled("film 2s long\n\nrepeat 100 times: nod\n").codes == ["FS414"]


def test_scenes_after_the_film_are_told() -> None:
    done = scheduled("film 1s long\n\nscene one:\n    wait 3s\nscene two:\n    nod\n")
    assert done.codes == ["FS414"]
    assert [scene.name for scene in done.solved.scenes] == ["one"]


def test_a_drop_in_a_loop_needs_to_find_something_once() -> None:
    assert scheduled("add smile\nrepeat 2 times:\n    drop smile\n").codes == []
    assert scheduled("add smile for 1s\ndrop smile\n").codes == ["FS416"]


class Broken:
    """A voice that cannot speak."""

    def speak(self, line: Say) -> Spoken:
        raise VoiceFailure("it is not there")


def test_a_broken_voice_is_told_once() -> None:
    span = Span(Source("by hand", "say say"), 0, 3)
    lines = tuple(Do(Say(text, Voice()), "ada", None, span) for text in ("one", "two"))
    scene = Scene("main", ("ada",), Sequence(lines, span, True), span)
    play = Play(Film(), (Face("ada", "woman", Voice(), Life("calm"), span),), (), (scene,))
    diagnostics = Diagnostics()
    assert schedule(play, Broken(), diagnostics) is None
    assert [item.code for item in diagnostics] == ["FS501"]
    assert schedule(play, Metronome(), Diagnostics()) is not None


def test_a_long_line_is_in_the_way_of_all_that_follow() -> None:
    done = scheduled('say "one two three four five"\nat 300ms: say "six"\nat 1.2s: say "seven"\n')
    first = 'say "one two three four five"'
    assert places(done, "FS403") == [('say "six"', [first]), ('say "seven"', [first])]


CROWD = f"target c of {' (0cm 0cm 1m)' * 300}\n\n"
VISITOR = "target visitor moves\n    0s -80cm 0cm 20cm\n    9s 80cm 0cm 20cm\n\n"
CALLS = "".join(f'event heard "no" at {number * 0.3:.1f}s\n' for number in range(2000))
SAID = 'say "one two three four five"\n\nwhen heard "no":\n    say "six seven eight nine"\n'


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("repeat 6000 times:\n    look left 20deg\n    look right 20deg\n", "FS422"),
        ("repeat 2000 times:\n    look left 80deg, speed 1%\n    look right 80deg, speed 1%\n", "FS422"),
        (f"{VISITOR}repeat 9000 times:\n    look at visitor for 1s\n", "FS422"),
        (f"{SAID}    restart\n\n{CALLS}", "FS422"),
        (f"{SAID}\n{CALLS}", "FS422"),
        (f"{CROWD}scene s:\n    repeat 1000 times: look at c.nearest\n", "FS412"),
        (f"repeat 5000 times:\n    show {' + '.join(['smile 1%'] * 500)}\n", "FS412"),
        ("when signal 'a':\n    nod\n".replace("'", '"') * 400 + "nod\n\n" + 'event signal "a" at 1s\n' * 400, "FS412"),
        ("repeat 100 times: wait 1000s\n", "FS423"),
        ("nod for 14401s\n", "FS423"),
    ],
)
def test_what_is_too_much_is_told_before_it_takes_long(text: str, code: str) -> None:
    assert scheduled(text).codes == [code]


def test_many_looks_around_a_moving_target_are_timed() -> None:
    done = scheduled(f"{VISITOR}repeat 500 times:\n    look at visitor\n    look at camera for 300ms\n")
    assert done.codes == []
    assert len(done.solved.acts) == 1000
