"""Warnings that help: looks and expressions that come to nothing, lines that sound at once, with places and times."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scheduling import Scheduled, scheduled

from facescript.compile import compile_source
from facescript.diagnostics.model import Severity
from facescript.motion.perform import perform
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

TWO = "face a = woman\nface b = man\n"
LONG = 'a: say "one two three four five" as hello\n'


def told(done: Scheduled, *codes: str) -> list[tuple[str, str, list[str]]]:
    """Code, text and other places of each warning of these codes."""
    return [
        (item.code, item.span.text, [other.span.text for other in item.related])
        for item in done.diagnostics
        if item.span is not None and (item.code in codes or (not codes and item.severity is Severity.WARNING))
    ]


def only(text: str, code: str, estimated: bool = False) -> str:
    """The message of the one diagnostic of a script."""
    (item,) = [item for item in scheduled(text, estimated).diagnostics if item.severity is not Severity.HINT]
    assert (item.code, item.severity) == (code, Severity.WARNING)
    return item.message


# ------------------------------------------------------------------------------------------------ two looks at once


@pytest.mark.parametrize(
    ("first", "second", "message"),
    [
        ("look left 20deg", "look right 10deg", "eyes and head at 0 s: this one is later in the script and wins."),
        (
            "look left 20deg",
            "glance camera",
            "eyes and head at 0 s: this one is later in the script and wins until 0.5 s.",
        ),
        ("look left 20deg", "look right 10deg, eyes only", "eyes at 0 s: this one is later in the script and wins."),
        ("look left 20deg, head only", "look right 10deg", "head at 0 s: this one is later in the script and wins."),
    ],
)
def test_two_looks_at_once(first: str, second: str, message: str) -> None:
    text = f"together:\n    {first}\n    {second}\n"
    assert only(text, "FS605").endswith(message)
    assert told(scheduled(text)) == [("FS605", second, [first])]


@pytest.mark.parametrize(
    "text",
    [
        "together:\n    look left 20deg, head only\n    look right 10deg, eyes only\n",
        "look left 20deg\nlook right 10deg\n",
        "look left 20deg over 0ms\nglance camera\n",
        "face a = woman\nface b = man\ntogether:\n    a: look left 20deg\n    b: look left 20deg\n",
        "together:\n    look left 20deg, latency 500ms\n    look right 10deg\n",
    ],
)
def test_looks_that_are_in_nobodys_way(text: str) -> None:
    assert told(scheduled(text)) == []


def test_a_latency_counts() -> None:
    text = "at 300ms: look left 20deg\nlook right 10deg, latency 300ms\n"
    assert " at 0.3 s: " in only(text, "FS605")


# ------------------------------------------------------------------------------------------------ looks too short


def test_a_look_shorter_than_the_eyes_need() -> None:
    assert only("wait 1s\nlook left 20deg for 30ms\n", "FS606") == (
        "This look is over at 1.03 s: the eyes of `somebody` would be there at 1.079 s, 0.079 s after its start."
    )
    assert "the head of" in only("look left 20deg, head only for 100ms\n", "FS606")
    assert only("target c of (-60cm 0cm 2m) (50cm 0cm 2m)\nscan c, 20ms each\n", "FS606").startswith(
        "A look of this scan"
    )


def test_a_look_that_the_next_takes_the_place_of() -> None:
    text = "look left 20deg\nat 20ms: look right 20deg\n"
    assert told(scheduled(text)) == [("FS606", "look left 20deg", ["look right 20deg"])]
    assert "is over at 0.02 s" in only(text, "FS606")


@pytest.mark.parametrize(
    "text",
    [
        "look left 20deg over 0ms for 10ms\n",
        "look left 20deg\nlook right 20deg\nlook left 5deg for 100ms\n",
        "look left 20deg\nat 20ms: glance camera\n",
        "look left 20deg, eyes only\nat 20ms: look right 20deg, head only\n",
        "look at camera for 10ms\n",
        "film 50ms long\n\nlook left 20deg for 2s\n",
        "repeat for 1s:\n    look left 20deg for 490ms\n",
    ],
)
def test_looks_that_have_their_time(text: str) -> None:
    assert told(scheduled(text), "FS605", "FS606") == []


def test_what_an_event_interrupts_is_not_told() -> None:
    event = 'when heard "no":\n    look right 20deg\n    show frown\n\nevent heard "no" at 20ms\n'
    assert told(scheduled(f"scene s:\n    look left 20deg\n    wait 1s\n\n{event}")) == []
    assert told(scheduled(f"scene s:\n    show smile\n    wait 1s\n\n{event}")) == []


def test_a_look_in_a_repeat_is_told_once() -> None:
    assert len(told(scheduled("repeat 5 times:\n    look left 20deg for 30ms\n    wait 1s\n"))) == 1


# ------------------------------------------------------------------------------------------------ expressions


def test_a_show_that_is_covered_before_its_apex() -> None:
    text = "show smile\nat 100ms: show frown\n"
    assert only(text, "FS425") == (
        "This would be at its apex at 0.5 s, and is let go from 0.1 s on: it comes to 47 % of it."
    )
    assert told(scheduled(text)) == [("FS425", "show smile", ["show frown"])]


def test_an_add_that_is_dropped_before_its_apex() -> None:
    text = "add smile over 2s\nat 1s: drop smile\n"
    assert told(scheduled(text)) == [("FS425", "add smile over 2s", ["drop smile"])]


@pytest.mark.parametrize(
    "text",
    [
        "show smile 70%\nat 100ms: show frown\n",
        "show smile 70% over 2s ease in\nat 1500ms: show neutral over 900ms ease out\n",
        "add smile 70% over 2s\nat 700ms: drop smile over 300ms\n",
        "show smile 70% over 1s for 3s\nat 400ms: show frown, posed\n",
    ],
)
def test_what_is_told_of_an_apex_is_what_is_drawn(text: str) -> None:
    done = scheduled(f"life still\n{text}")
    (item,) = [item for item in done.diagnostics if item.code == "FS425"]
    performance = perform(done.solved)
    corner = performance.sample(np.arange(0.0, 4.0, 0.001))[:, performance.names.index("cheek.lower.left")]
    assert float(item.message.split("comes to ")[1].split()[0]) / 100 == pytest.approx(corner.max() / 0.7, abs=0.01)


def test_the_curve_and_the_manner_count() -> None:
    shares = [
        int(only(f"show smile over 1s{how}\nat 400ms: show frown over 0ms\n", "FS425").split("comes to ")[1].split()[0])
        for how in (" ease in", " ease linear", "", " ease out", ", posed")
    ]
    assert shares == [10, 40, 32, 58, 58]


@pytest.mark.parametrize(
    "text",
    [
        "show smile\nshow frown\n",
        "show smile\nat 480ms: show frown\n",
        "show smile 40%\nat 100ms: show smile 80% + AU4\n",
        "show neutral\nat 100ms: show smile\n",
        "show smile\nat 100ms: show frown for 1s\n",
        "show smile\nat 100ms: add AU4\n",
        "add lid 100% for 200ms\n",
        "show smile for 200ms\n",
        'say "one [smile 40%]two[/] three"\n',
    ],
)
def test_expressions_that_come_to_be(text: str) -> None:
    assert told(scheduled(text)) == []


def test_less_of_the_same_is_let_go() -> None:
    assert told(scheduled("show smile 80%\nat 100ms: show smile 20%\n"), "FS425")


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("show smile over 2s for 1s", "This was to rise in 2 s, until 2 s, and lets go at 1 s: it rises in 1 s."),
        (
            "show smile for 500ms, spontaneous",
            "This was to rise in 1 s, until 1 s, and lets go at 0.5 s: it rises in 0.5 s.",
        ),
        ("show smile for 500ms, posed", ""),
        ("show smile over 1s for 800ms", ""),
        ('say "[smile over 1s]one[/]"', "This was to rise in 1 s, until 1 s, and lets go at 0.3 s: it rises in 0.3 s."),
    ],
)
def test_a_rise_that_is_hurried(line: str, message: str) -> None:
    found = [item.message for item in scheduled(f"{line}\n").diagnostics if item.code == "FS424"]
    assert found == ([message] if message else [])


def test_a_cut_hurries_nobody() -> None:
    assert told(scheduled("repeat for 500ms:\n    show smile over 2s\n"), "FS424") == []
    assert told(scheduled("film 500ms long\n\nshow smile over 2s for 3s\n"), "FS424") == []


# ------------------------------------------------------------------------------------------------ two voices


def test_two_faces_that_speak_at_once() -> None:
    text = f'{TWO}{LONG}at 500ms: b: say "six"\n'
    assert only(text, "FS426") == "`b` speaks from 0.5 s on, and `a` still speaks until 1.5 s."
    assert told(scheduled(text)) == [("FS426", 'say "six"', ['say "one two three four five" as hello'])]
    assert "until about 1.5 s" in only(text, "FS426", estimated=True)


def test_a_narrator_counts_too() -> None:
    assert only('face a = woman\nface n = unseen\na: say "one two three"\nat 500ms: n: say "six"\n', "FS426")


@pytest.mark.parametrize(
    "text",
    [
        'together:\n    a: say "one two"\n    b: say "one two"\n',
        'together:\n    a: say "one two three"\n    in turn:\n        wait 300ms\n        b: say "six"\n',
        'a: say "one two three"\n    on "two": b: say "six"\n',
        f'{LONG}at hello."three": b: say "six"\n',
        f'{LONG}at hello.end - 200ms: b: say "six"\n',
        f'{LONG}at hello.start: b: say "six"\n',
        f'{LONG}b: say "six"\na: say "seven"\n',
        f'{LONG}at 1500ms: b: say "six"\n',
    ],
)
def test_voices_that_are_meant_or_apart(text: str) -> None:
    assert told(scheduled(TWO + text), "FS426") == []


def test_a_start_does_not_say_that_lines_shall_sound_at_once() -> None:
    assert told(scheduled(f'{TWO}{LONG}at hello.start + 400ms: b: say "six"\n'), "FS426")


def test_what_a_reaction_says_beside_a_scene_is_not_told() -> None:
    event = 'when heard "no":\n    b: say "six"\n\nevent heard "no" at 300ms\n'
    assert told(scheduled(f"{TWO}\nscene s:\n    {LONG}\n{event}")) == []


# ------------------------------------------------------------------------------------------------ out of reach


def test_a_gaze_out_of_reach_says_when_and_where() -> None:
    text = (
        "film screen none\ntarget bird moves\n    1s {start}deg 0deg 2m\n    3s 150deg 0deg 2m\nlook at bird\nwait 4s\n"
    )
    for start, code, words in ((100, "FS601", "At 3 s this target is "), (0, "FS603", "At 3 s this target is ")):
        source = Source("script.face", text.format(start=start))
        found = compile_source(source, World(Path(__file__).parent), EstimatedVoice()).diagnostics
        (item,) = [item for item in found if item.code == code]
        assert item.message.startswith(words)
        assert [other.span.text.split()[:2] for other in item.related] == [["target", "bird"]]
