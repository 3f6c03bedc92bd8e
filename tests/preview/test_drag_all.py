"""Whatever is dragged in whatever script: either it is refused with a sentence, or just that moves which should."""

from __future__ import annotations

import re
from collections import Counter

import pytest
from dragged import ROOT, Desk, laid_out
from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.preview.drag import Refused
from facescript.preview.dragging.amounts import Change
from facescript.preview.dragging.lengths import end_of, is_open
from facescript.preview.dragging.tries import Handle
from facescript.schedule.score import TimedAct

SCRIPTS = ("dialogue", "evening", "gaze", "gestures", "kiosk", "recorded", "scenes", "timed", "words")
"""The examples that others add nothing to."""

TIMES: tuple[Handle, ...] = ("start", "body", "end")


@pytest.mark.parametrize("name", SCRIPTS)
def test_the_examples(name: str) -> None:
    desk = Desk((ROOT / f"{name}.face").read_text("utf-8"), f"{name}.face")
    seen: set[tuple[str, int]] = set()
    for number, act in enumerate(desk.score.acts):
        place = act.span.source.name, act.span.start
        if place not in seen:
            seen.add(place)
            check(desk, act, TIMES[number % 3], (-0.31, 0.24, 0.5, 1.0)[number % 4])
            check(desk, act, "degree", 0.35)


LINES = (
    "nod",
    "nod 40% for 1.2s  # yes",
    "show smile 60%",
    "show frown for 800ms",
    "add AU4 30% over 200ms  # a little",
    "add brow.inner 50% for 1s back in 300ms, posed",
    "blink",
    "tilt left",
    "look left 20deg",
    "look at camera for 1s, eyes only",
    "glance camera",
    "drop smile",
    "wait 300ms",
    "wait 1s  # a while",
    "wait until 4s",
    'say "Hello [brows 40%]there."',
)
BLOCKS = ("together:", "in turn:", "at 1.5s:", "repeat 2 times:")


def indented(lines: list[str]) -> list[str]:
    return [f"    {line}" for line in lines]


statements = st.recursive(
    st.sampled_from(LINES).map(lambda line: [line]),
    lambda inner: st.builds(
        lambda head, bodies: [head, *(line for body in bodies for line in indented(body))],
        st.sampled_from(BLOCKS),
        st.lists(inner, min_size=1, max_size=3),
    ),
    max_leaves=5,
)
scripts = st.lists(statements, min_size=1, max_size=5).map(
    lambda bodies: laid_out("".join(f"{line}\n" for body in bodies for line in body))
)


@given(scripts, st.sampled_from([*TIMES, "degree"]), st.integers(0, 9), st.integers(-15, 30))
@settings(max_examples=30, deadline=None)
def test_any_script(text: str, handle: Handle, number: int, tenths: int) -> None:
    try:
        desk = Desk(text)
    except AssertionError:
        return
    if desk.score.acts:
        act = desk.score.acts[number % len(desk.score.acts)]
        check(desk, act, handle, abs(tenths) / 30 if handle == "degree" else tenths / 10 + 0.01)


def check(desk: Desk, act: TimedAct, handle: Handle, by: float) -> None:
    """A drag is refused with a sentence, or its edit is small, in the layout, and does what was asked."""
    change = desk.drag(act, handle, by)
    if isinstance(change, Refused):
        assert change.what.startswith("`") and change.why.endswith(".") and len(change.why) > 20
        return
    assert handle in desk.drags.handles(act)
    text = desk.text[: change.start] + change.text + desk.text[change.end :]
    assert laid_out(text) == text
    assert touched(desk, act, change, text)
    moved(desk, act, handle, by, text)


def touched(desk: Desk, act: TimedAct, change: Change, text: str) -> bool:
    """Whether the edit is in the lines of the statement, of a `wait`, or of the `at` that it stands in."""
    line = act.span.source.line(act.span.source.position(act.span.start)[0])
    own = bare(line)[-1][:3]
    old, new = bare(desk.text), bare(text)
    for words in (Counter(new) - Counter(old)) + (Counter(old) - Counter(new)):
        assert words.startswith(("wait ", own)), (words, own)
    return len(new) - len(old) in (-1, 0, 1)


def bare(text: str) -> list[str]:
    """The lines of a text, one for each statement, without comments, moments and names of faces."""
    lines = re.sub(r" *#.*", "", text).replace(",\n", ", ").split("\n")
    return [re.sub(r"  +", " ", re.sub(r"^(at [^:]*: ?|\w+: )*", "", line.strip())) for line in lines]


def moved(desk: Desk, act: TimedAct, handle: Handle, by: float, text: str) -> None:
    """The act is where it was dragged; what began before it is where it was, what follows moved with it at most."""
    score = desk.again(text).score
    assert score is not None and len(score.acts) == len(desk.score.acts)
    after = {one.order: one for one in score.acts}
    now = after[act.order]
    begins = act.start + (by if handle in ("start", "body") else 0.0)
    assert now.start == pytest.approx(begins, abs=0.021)
    if handle == "body" and not is_open(act):
        assert end_of(now) == pytest.approx(end_of(act) + by, abs=0.021)
    if handle == "start" and not is_open(act) and desk.drags.handles(act).get("end"):
        assert end_of(now) == pytest.approx(end_of(act), abs=0.021)
    if handle == "end":
        shown = min(act.released, desk.score.scenes[act.scene].end) if is_open(act) else end_of(act)
        assert end_of(now) == pytest.approx(shown + by, abs=0.03)
    shifts = (0.0, now.start - act.start, now.settled - act.settled)
    for one in desk.score.acts:
        other = after[one.order].start - one.start
        if one.start < min(act.start, now.start) - 0.02:
            assert other == pytest.approx(0.0, abs=0.021)
        elif one.order != act.order:
            assert min(shifts) - 0.09 <= other <= max(shifts) + 0.09
