"""Who owned a channel: the parts that are told recombine, by the law written out, to the very value that is drawn."""

from __future__ import annotations

from collections.abc import Sequence
from math import hypot, prod, tanh

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st
from scripted import Played, played, script, scripts

from facescript.motion.compose import BLINK_TURN, TURNED, TURNS
from facescript.motion.perform import perform
from facescript.owners.account import Accounts
from facescript.owners.model import Account, Part, Step
from facescript.owners.telling import as_objects, as_text
from facescript.performance.channels import INDEX, MUSCLES, NAMES, SIDES

MUSCLE_NAMES = [f"{muscle}.{side}" for muscle in MUSCLES for side in SIDES]
AXES = ("yaw", "pitch", "roll")


def accounts(made: Played) -> Accounts:
    return Accounts(made.score, made.score.faces[0])


def limited(total: float) -> float:
    return max(0.0, total) if total <= 0.8 else 0.8 + 0.2 * tanh((total - 0.8) / 0.2)


def added(parts: Sequence[Part]) -> float:
    return sum(part.value for part in parts)


def left_open(parts: Sequence[Part]) -> float:
    """What blinks leave open: each gesture's its own share; what is shown adds up, and what a life does."""
    kinds = {
        "shown": [part for part in parts if part.source.what.startswith(("show", "add"))],
        "life": [part for part in parts if part.source.what.startswith("life")],
    }
    others = [part for part in parts if not any(part in kind for kind in kinds.values())]
    blinks = [added(kind) for kind in kinds.values()] + [part.value for part in others]
    return prod(1.0 - min(1.0, max(0.0, blink)) for blink in blinks)


def by_rule(account: Account, word: str) -> Step:
    return next(step for step in account.steps if word in step.rule)


def close(value: float) -> object:
    return pytest.approx(value, abs=1e-9)


# ------------------------------------------------------------------------------------------------ random scripts


@settings(max_examples=20, deadline=None)
@given(scripts(), st.lists(st.floats(0.0, 0.5), min_size=2, max_size=2))
@example(script(["at 1200ms: nod", "at 1880ms: glance camera", "at 530ms: scan crowd, 300ms each"]), [0.0, 0.0])
@example(script(["at 0ms: look at shelf", "at 100ms: shake", "at 200ms: look at lamp"]), [0.1, 0.2])
def test_the_parts_of_every_channel_come_to_what_is_drawn(text: str, after: list[float]) -> None:
    """Soon after a statement begins, when it is laid over what was before."""
    made = played(text)
    starts = [act.start for act in made.score.acts]
    times = [start + later for start, later in zip(starts[-2:], after, strict=False)]
    asked, performance = accounts(made), perform(made.score)
    for time in times:
        drawn = performance.sample(np.array([time]))[0]
        told = {name: asked.at(name, time) for name in NAMES}
        assert [told[name].value for name in NAMES] == drawn.tolist()
        for name in MUSCLE_NAMES:
            assert limited(added(told[name].steps[0].parts)) == close(told[name].value)
        for name in ("head.x", "head.y", "head.scale", "eye.left.scale", "eye.right.x", "pupil.left"):
            rest = 1.0 if name.endswith(("scale", "pupil.left")) else 0.0
            assert max(rest + added(told[name].steps[0].parts), 0.05 if rest else -1e9) == close(told[name].value)
        for side in SIDES:
            lid_comes_about(told[f"lid.{side}"])
            eye_comes_about(told, side)
        head_comes_about(told)
        mouth_comes_about(told)


def lid_comes_about(lid: Account) -> None:
    total = added(by_rule(lid, "sum").parts)
    shown = max(total, -0.35) if total < 0 else limited(total)
    opening = (1.0 - shown) * left_open(by_rule(lid, "blinks").parts)
    assert 1.0 - by_rule(lid, "blinks").value == close(opening)
    pitch = added(by_rule(lid, "up and down").parts)
    shift = pitch * 0.95 / 48.0
    opening *= 1.0 + 0.35 * limited(shift / 0.35) - limited(-shift)
    assert min(1.0, max(-0.35, 1.0 - opening)) == close(lid.value)


def head_comes_about(told: dict[str, Account]) -> None:
    for axis, limit in zip(AXES, (45.0, 30.0, 30.0), strict=True):
        head = told[f"head.{axis}"]
        gaze = by_rule(head, "gaze") if axis != "roll" else None
        turned = added(gaze.parts) if gaze else 0.0
        assert gaze is None or gaze.value == close(turned)
        more = added(by_rule(head, "added").parts)
        if abs(turned + more) <= limit - 5.2 and abs(turned) <= limit - 5.2:
            assert turned + more == close(head.value)
        assert abs(head.value) <= limit


def eye_comes_about(told: dict[str, Account], side: str) -> None:
    for axis in AXES:
        eye = told[f"eye.{side}.{axis}"]
        own = by_rule(eye, "own terms")
        assert own.value == close(eye.steps[eye.steps.index(own) - 1].value + added(own.parts))
        if axis == "roll":
            assert eye.value == own.value
            continue
        sight = by_rule(eye, "line of sight")
        assert sight.value == close(added(sight.parts))
        moved = [step for step in eye.steps if step.rule == "moved by life"]
        assert not moved or moved[0].value == close(sight.value + added(moved[0].parts))
        pull = 0.0
        if eye.steps[-2].rule != own.rule and "pulled" in eye.steps[-3].rule:
            shut = 1.0 - left_open(eye.steps[-3].parts)
            turned = min(1.0, max(0.0, (shut - TURNS) / (TURNED - TURNS)))
            far = BLINK_TURN[1] if axis == "pitch" else BLINK_TURN[0] * (1.0 if side == "right" else -1.0)
            pull = far * turned**3 * (10.0 - 15.0 * turned + 6.0 * turned**2)
        both = [by_rule(told[f"eye.{side}.{name}"], "own terms").value for name in ("yaw", "pitch")]
        if hypot(both[0] / 45.0, (both[1] - 1.4) / 28.0) < 0.95:
            assert own.value + pull == close(eye.value)


def mouth_comes_about(told: dict[str, Account]) -> None:
    for part in ("wide", "round", "upper", "lower", "teeth", "tongue", "open", "jaw"):
        mouth = told[f"mouth.{part}"]
        shown, spoken = by_rule(mouth, "shown"), by_rule(mouth, "spoken")
        assert shown.value == close(added(shown.parts)) and spoken.value == close(added(spoken.parts))
        assert len(spoken.parts) <= 2
        if part in ("upper", "lower"):
            assert shown.value + spoken.value == close(mouth.value)


# ------------------------------------------------------------------------------------------------ one by one


def told(lines: Sequence[str], name: str, time: float, life: str = "still") -> Account:
    return accounts(played(script(lines, life))).at(name, time)


def test_a_show_under_a_later_one_has_its_share_of_the_base() -> None:
    smile, frown = "show smile 50% over 0ms", "at 1s: show AU12 over 1s ease linear"
    account = told([smile, frown], "cheek.lower.left", 1.25)
    older, newer = account.steps[0].parts
    assert (older.source.what, older.full, older.share) == ("show smile 50%", 0.5, pytest.approx(0.75))
    assert (newer.source.what, newer.full, newer.share) == ("show AU12", 1.0, pytest.approx(0.25))
    assert (older.state, newer.state) == ("under a later show", "rising")
    assert account.owner == newer.source and newer.source.file == "made.face"


def test_what_lets_go_and_what_is_dropped_say_so() -> None:
    lines = ["add AU1 for 1500ms back in 1s ease linear", "at 0ms: add AU1 40%", "at 1s: drop AU1 over 2s ease linear"]
    (first,) = told(lines[:1], "brow.inner.left", 2.0).steps[0].parts
    assert first.state == "letting go" and first.share == pytest.approx(0.5)
    parts = told(lines, "brow.inner.left", 2.0).steps[0].parts
    assert [part.state for part in parts] == ["letting go (50%), dropped (50%)", "dropped"]


def test_a_look_that_is_interrupted_is_told_beside_the_one_that_has_the_eyes() -> None:
    lines = ["at 1s: look at shelf", "at 1.03s: look at lamp as seen", "at 2s: glance cup, eyes only"]
    account = told(lines, "eye.left.yaw", 1.06)
    first, second = by_rule(account, "line of sight").parts[-2:]
    assert (first.source.what, first.state) == ("look at shelf", "interrupted")
    assert (second.source.what, second.state, second.source.label) == ("look at lamp", "on its way", "main.seen")
    assert account.owner == second.source
    assert told(lines, "head.yaw", 2.3).owner == second.source, "a glance with the eyes only leaves the head"
    back = told(lines, "gaze.yaw", 2.55).owner
    assert back is not None and back.what == "glance cup, eyes only, over: look at lamp again"


def test_a_life_is_told_by_what_it_does() -> None:
    whole = told(["wait 3s"], "head.roll", 2.0, "calm")
    assert [part.source.what for part in by_rule(whole, "added").parts] == ["life calm: head"]


def test_speech_owns_the_gap_and_tells_its_shapes() -> None:
    lines = ['say "Mama." as hello', "wait 2s"]
    account = told(lines, "mouth.open", 0.1)
    assert account.owner is not None and account.owner.what == 'say "Mama."' and account.owner.label == "main.hello"
    assert {part.source.what.split()[2] for part in by_rule(account, "spoken").parts} <= {"m", "a"}
    assert told(lines, "mouth.open", 3.0).at_rest


def test_a_channel_that_nothing_moves_is_at_rest() -> None:
    for name in ("brow.inner.left", "head.x", "pupil.left", "lid.left", "mouth.jaw"):
        account = told(["nod"], name, 3.5)
        assert account.at_rest and account.owner is None
        assert "at rest" in as_text([account])


def test_text_and_json_say_the_same() -> None:
    account = told(["show smile 60%"], "cheek.lower.left", 1.0)
    assert as_text([account]).splitlines() == [
        "ada.cheek.lower.left at 1 s: 0.6",
        "  owner: show smile 60% (made.face:14)",
        "      0.6000  sum",
        "      0.6000    show smile 60% (made.face:14), holds",
        "      0.6000  drawn",
    ]
    (told_as,) = as_objects([account])
    assert told_as["value"] == 0.6 and told_as["owner"] == {"what": "show smile 60%", "file": "made.face", "line": 14}
    assert [step["value"] for step in told_as["steps"]] == [step.value for step in account.steps]  # type: ignore[union-attr]
    assert INDEX[str(told_as["channel"])] == NAMES.index("cheek.lower.left")
