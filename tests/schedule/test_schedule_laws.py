"""Laws of time, for scripts of every shape."""

from __future__ import annotations

from itertools import pairwise

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scheduling import scheduled

from facescript.ir.acts import Gesture, Look, Say
from facescript.schedule.explain import as_objects, explain

LEAVES = (
    "nod",
    "blink",
    "wait 300ms",
    "wait 1s to 2s",
    "look left 20deg",
    "look away",
    "glance camera",
    "show smile 20% to 80% for 1s",
    "add brow.outer 40% for 500ms",
    'say "one two three"',
)

leaves = st.sampled_from(LEAVES).map(lambda text: [text])


def headed(head: str, blocks: st.SearchStrategy[list[str]]) -> st.SearchStrategy[list[str]]:
    return blocks.map(lambda lines: [f"{head}:", *(f"    {line}" for line in lines)])


def sequences(inner: st.SearchStrategy[list[str]]) -> st.SearchStrategy[list[str]]:
    return st.lists(inner, min_size=1, max_size=4).map(lambda rows: [line for row in rows for line in row])


def blocks(inner: st.SearchStrategy[list[str]]) -> st.SearchStrategy[list[str]]:
    body = sequences(inner)
    return st.one_of(headed("in turn", body), headed("repeat 2 times", body), headed("choose", body))


statements = st.recursive(leaves, blocks, max_leaves=8)
scripts = sequences(statements).map(lambda lines: "film seed 5\n\nscene one:\n" + indented(lines))
few = settings(max_examples=30, deadline=None)


def indented(lines: list[str]) -> str:
    return "".join(f"    {line}\n" for line in lines)


@few
@given(scripts)
def test_a_sequence_never_goes_back(text: str) -> None:
    score = scheduled(text).solved
    acts = sorted(score.acts, key=lambda act: act.order)
    assert all(before.settled <= after.start + 1e-9 for before, after in pairwise(acts))
    assert all(act.start <= act.settled <= act.end + 1e-9 for act in acts)
    assert score.duration >= max((act.settled for act in acts), default=0.0)


@few
@given(st.lists(statements, min_size=1, max_size=3))
def test_together_settles_with_the_last(parts: list[list[str]]) -> None:
    silent = [[line.replace('say "one two three"', "nod").replace("show smile 20% to 80%", "add AU4") for line in part]
              for part in parts]  # fmt: skip
    turns = [["in turn:", *(f"    {line}" for line in part)] for part in silent]
    body = ["together:", *(f"    {line}" for turn in turns for line in turn), "shake as after"]
    score = scheduled("scene one:\n" + indented(body)).solved
    *inside, after = sorted(score.acts, key=lambda act: act.order)
    assert after.start >= max((act.settled for act in inside), default=0.0)


@few
@given(scripts)
def test_the_same_script_has_the_same_score(text: str) -> None:
    first, second = (as_objects(explain(scheduled(text).solved)) for _ in range(2))
    assert first == second


@few
@given(scripts, st.sampled_from(LEAVES), st.booleans())
def test_another_scene_changes_no_draw(text: str, leaf: str, before: bool) -> None:
    """Whatever is inserted in another scene, this one is drawn as it was, only later."""
    head, _, body = text.partition("scene one:\n")
    other = f"scene other:\n    {leaf}\n    nod 20% to 60%\n"
    changed = f"{head}{other}scene one:\n{body}" if before else f"{head}scene one:\n{body}{other}"
    (verbs, times), (verbs_then, times_then) = shape(text), shape(changed)
    assert verbs == verbs_then
    assert times == pytest.approx(times_then, abs=1e-3)


def shape(text: str) -> tuple[list[object], list[float]]:
    """What is done in scene one, and the starts and settled times from its start."""
    score = scheduled(text).solved
    number = [scene.name for scene in score.scenes].index("one")
    start = score.scenes[number].start
    acts = sorted((act for act in score.acts if act.scene == number), key=lambda act: act.order)
    times = [time - start for act in acts for time in (act.start, act.settled)]
    return [act.verb for act in acts], times


def test_a_wait_between_changes_no_nod() -> None:
    """A draw is known by what is drawn and how many such stand before it in its block."""
    first = "film seed 3\n\nnod 20% to 80%\nnod 20% to 80%\n"
    then = "film seed 3\n\nblink\nnod 20% to 80%\nwait 1s\nshow smile\nnod 20% to 80%\n"
    degrees, later = (
        [act.verb.degree for act in scheduled(text).solved.acts if isinstance(act.verb, Gesture)]
        for text in (first, then)
    )
    assert degrees == later[1:]
    assert degrees[0] != degrees[1]


def test_another_seed_is_another_film() -> None:
    text = "film seed {}\n\nrepeat 10 times:\n    choose:\n        nod\n        shake\n        blink\n"
    kinds = {
        tuple(act.verb.kind for act in scheduled(text.format(seed)).solved.acts if isinstance(act.verb, Gesture))
        for seed in range(4)
    }
    assert len(kinds) == 4
    assert all(len(set(row)) > 1 for row in kinds)


@few
@given(st.integers(0, 6), st.integers(1, 5), st.booleans())
def test_a_look_settles_when_its_eyes_are_there(lead: int, count: int, moving: bool) -> None:
    """However the looks hang together: the plan and the times agree, with moving targets too."""
    target = "target ball moves\n    0s -60cm 0cm 80cm\n    2s 60cm 10cm 80cm\n    5s -60cm 0cm 60cm\n"
    body = ["wait 700ms"] * lead + ["look at ball" if moving else "look left 25deg", "look right 10deg", "nod"] * count
    score = scheduled(f"{target}\nscene one:\n{indented(body)}").solved
    looks = [act for act in score.acts if isinstance(act.verb, Look)]
    assert len(looks) == 2 * count
    assert all(abs(act.plan[0].landed - act.settled) < 1e-4 for act in looks)
    assert all(act.plan[0].eye_onset == act.start for act in looks)


@few
@given(st.floats(0.0, 5.0).map(lambda time: round(time, 2)), st.integers(1, 4))
def test_a_broken_line_is_said_whole_in_the_end(time: float, count: int) -> None:
    lines = '    say "one two three four five"\n' * count
    text = f'scene one:\n{lines}\nwhen heard "no":\n    say "wait now"\n    nod\n\nevent heard "no" at {time:g}s\n'
    done = scheduled(text)
    score = done.solved
    assert done.codes == []
    whole = [line for line in score.lines if line.cut is None]
    assert len(whole) == count + 1
    ends = sorted((line.start, line.end) for line in score.lines)
    assert all(before[1] <= after[0] + 1e-9 for before, after in pairwise(ends))
    for line in score.lines:
        if line.cut is not None:
            spoken = line.cut - line.start
            assert any(abs(word.end - spoken) < 1e-6 for word in line.spoken.words)


def test_words_of_lines_are_in_them() -> None:
    score = scheduled('say "one two three" as hello\nat hello."two".end: nod\n').solved
    assert [act.start for act in score.acts if not isinstance(act.verb, Say)] == [0.6]
