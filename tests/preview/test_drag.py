"""Dragging an act of the timeline changes the script by the smallest edit, or says why it cannot."""

from __future__ import annotations

import pytest
from dragged import ROOT, Desk

from facescript.preview.dragging.tries import Handle

TWO = "face ada = woman\nface bruno = man\n"

NUMBERS: list[tuple[str, str, Handle, float, str]] = [
    ("show smile for 1s\nnod\n", "show", "end", 0.4, "show smile for 1.4s\nnod\n"),
    ("show smile for 600ms\n", "show", "end", 0.8, "show smile for 1400ms\n"),
    ("show smile for 0.5s as s\n", "show", "end", 0.123, "show smile for 0.62s as s\n"),
    ("show smile for 100ms + 1s\n", "show", "end", 0.4, "show smile for 100ms + 1.4s\n"),
    ("nod\n", "nod", "end", 0.5, "nod for 1.2s\n"),
    ("nod as n\nblink\n", "nod", "end", 0.2, "nod for 900ms as n\nblink\n"),
    ("glance camera, eyes only\n", "glance", "end", 0.5, "glance camera for 1s, eyes only\n"),
    ("show smile\ndrop smile\n", "drop", "end", -0.2, "show smile\ndrop smile over 300ms\n"),
    ("view all 120% over 1s\n", "view", "end", 1.0, "view all 120% over 2s\n"),
    ("target c of (0cm 0cm 2m) (9cm 0cm 2m)\nscan c, 600ms each\n", "scan", "end", 0.4, "800ms each"),
    ("target c of (0cm 0cm 2m) (9cm 0cm 2m)\nscan c, nearest first as s\n", "scan", "end", 0.4, "scan c, "),
    ("say \"Well, [look left for 200ms]hm.\"\n", "[look", "end", 0.1, "[look left for 300ms]hm"),
    ("wait 1s\nnod\n", "nod", "body", 0.5, "wait 1.5s\nnod\n"),
    ("wait 500ms\nnod\n", "nod", "body", -0.5, "nod\n"),
    ("wait 500ms  # so long\nnod\n", "nod", "body", -0.5, "wait 0ms  # so long\nnod\n"),
    ("nod\n# then\nblink\n", "blink", "body", 0.3, "nod\nwait 300ms\n# then\nblink\n"),
    ("nod\nwait 300ms + 1s\nblink\n", "blink", "body", -0.4, "nod\nwait 300ms + 0.6s\nblink\n"),
    ("nod\nwait until 2s\nblink\n", "blink", "body", 0.25, "nod\nwait until 2.25s\nblink\n"),
    ("at 2.3s: nod\n", "nod", "body", -0.3, "at 2s: nod\n"),
    ("nod as n\nat n.end + 500ms: blink\n", "blink", "body", -0.5, "nod as n\nat n.end: blink\n"),
    ("nod as n\nat n.end: blink\n", "blink", "body", 0.5, "nod as n\nat n.end + 500ms: blink\n"),
    ("nod as n\nat n.end + 200ms: blink\n", "blink", "body", -0.5, "nod as n\nat n.end - 300ms: blink\n"),
    ("at 1s:\n    nod\n    blink\n", "nod", "body", 1.0, "at 2s:\n    nod\n    blink\n"),
    ("at 1s:\n    nod\n    blink\n", "blink", "body", 1.0, "at 1s:\n    nod\n    wait 1s\n    blink\n"),
    ("together:\n    nod\n    blink\n", "blink", "body", 0.2, "together:\n    nod\n    at 200ms: blink\n"),
    ("wait 1s\nin turn:\n    nod\n    blink\n", "nod", "body", 1.0, "wait 2s\nin turn:\n    nod\n    blink\n"),
    ("say \"One.\"\nsay \"Two.\"\n", "say \"Two", "body", -0.15, "say \"One.\"\nwait 100ms\nsay \"Two.\"\n"),
    ("say \"One.\"\nsay \"Two.\"\n", "say \"Two", "start", 0.5, "say \"One.\"\nwait 750ms\nsay \"Two.\"\n"),
    ("wait 1s\nshow smile for 2s\nnod\n", "show", "start", -0.3, "wait 0.7s\nshow smile for 2.3s\nnod\n"),
    ("at 1s: show smile for 900ms\n", "show", "start", 0.2, "at 1.2s: show smile for 700ms\n"),
    ("show smile\nwait 2s\nnod\n", "show", "end", -1.4, "show smile for 1.8s\nwait 0.7s\nnod\n"),
    ("say \"A b.\"\nnod\nadd smile\n", "add", "end", -0.2, "add smile for 2"),
    ("nod 40%\n", "nod", "degree", 0.55, "nod 55%\n"),
    ("tilt left for 1s\n", "tilt", "degree", 0.5, "tilt left 50% for 1s\n"),
    ("show smile over 1s as s\n", "show", "degree", 0.3, "show smile 30% over 1s as s\n"),
    ("add head.roll 8deg for 1s\n", "add", "degree", -12.0, "add head.roll -12deg for 1s\n"),
    ("look left 20deg, eyes only\n", "look", "degree", 25.4, "look left 25deg, eyes only\n"),
    ("say \"[smile 40%]Hm, [nod]well.\"\n", "[smile", "degree", 0.6, "[smile 60%]Hm, [nod]well"),
    ("say \"[smile 40%]Hm, [nod]well.\"\n", "[nod", "degree", 0.6, "[nod 60%]well"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "words", "handle", "by", "after"), NUMBERS)
def test_a_drag_changes_one_number_or_adds_one(text: str, words: str, handle: Handle, by: float, after: str) -> None:
    found = Desk(text).after(words, handle, by)
    assert found == after if after.endswith("\n") else after in found


def test_faces_in_blocks_keep_them() -> None:
    block = TWO + "scene a:\n    together:\n        ada:\n            nod\n            blink\n        bruno: shake\n"
    assert "ada:\n            wait 200ms\n            nod" in Desk(block).after("nod", "body", 0.2)
    assert "together:\n        ada:\n" in Desk(block).after("shake", "body", 0.2)
    assert "        at 200ms: bruno: shake\n" in Desk(block).after("shake", "body", 0.2)
    line = TWO + "scene a:\n    ada: nod\n    bruno: wait 300ms\n    ada: blink\n"
    assert "    bruno: wait 500ms\n    ada: blink\n" in Desk(line).after("blink", "body", 0.2)


def test_comments_beside_lines_stay_below_each_other() -> None:
    text = "show smile for 1s  # at first\nnod                # then\n"
    longer = "show smile for 1.45s  # at first\nnod                   # then\n"
    assert Desk(text).after("show", "end", 0.45) == longer
    apart = "show smile for 1s  # at first\nwait 500ms\nnod  # then\n"
    assert Desk(text).after("nod", "body", 0.5) == apart
    assert Desk("show smile for 1s # x\nnod # y\n").after("show", "end", 0.45) == "show smile for 1.45s # x\nnod # y\n"


REFUSED: list[tuple[str, str, Handle, float, str]] = [
    ("repeat 2 times:\n    nod\n", "nod", "end", 0.3, "it stands in a `repeat`: each of its passes would change."),
    ("action bow:\n    nod\nbow\nbow\n", "nod", "end", 0.3, "played 2 times"),
    ("let beat = 1s\nshow smile for beat\n", "show", "end", 0.3, "`beat`, which line 1 defines"),
    ("let beat = 1s\nwait beat\nnod\n", "nod", "body", 0.3, "the `wait` before it (line 2) is `beat`"),
    ("let beat = 1s\nat beat: nod\n", "nod", "body", 0.3, "its moment (line 2) is `beat`"),
    ("show smile for 1s to 3s\n", "show", "end", 0.3, "drawn by the seed, `1s to 3s`"),
    ("say \"Hello there.\"\n", "say", "end", 0.3, "how long it lasts is the voice's"),
    ("say \"Hello there.\"\n    on \"there\": nod\n", "nod", "body", 0.3, "it starts on the word “there”"),
    ("say \"Hello [nod]there.\"\n", "[nod", "body", 0.3, "it starts on the word behind its bracket"),
    ("nod\nblink\nshake\n", "blink", "body", -0.3, "cannot come sooner"),
    ("wait 200ms\nblink\n", "blink", "body", -0.3, "the `wait` before it is only 200ms."),
    ("show smile\nnod\nnod\n", "show", "end", -0.5, "what stands behind it would wait"),
    ("blink\n", "blink", "end", -0.3, "nothing would be left of it"),
    ("shake\n", "shake", "end", -0.4, "it would be played from"),
    ("show smile 40% + AU4\n", "show", "degree", 0.5, "it is a sum"),
    ("look away\n", "look", "degree", 0.5, "it has no degree"),
    ("background #102030\nscene a:\n    nod\n", "scene", "end", 0.5, "it stands before the scenes"),
]  # fmt: skip


@pytest.mark.parametrize(("text", "words", "handle", "by", "why"), REFUSED)
def test_what_cannot_be_dragged_says_why(text: str, words: str, handle: Handle, by: float, why: str) -> None:
    assert why in Desk(text).after(words, handle, by)


def test_draws_of_others_are_not_drawn_anew() -> None:
    text = "nod\nwait 100ms to 2s\nblink\nshake\nwait 100ms to 2s\nblink\n"
    assert "(line 6) would move too" in Desk(text).after("shake", "body", 0.3)


def test_what_is_written_elsewhere_is_left_alone() -> None:
    desk = Desk((ROOT / "conversation.face").read_text("utf-8"))
    act = next(act for act in desk.score.acts if act.span.source is not desk.compiled.source)
    assert desk.drags.handles(act) == {} and "open that script" in desk.drag(act, "end", 0.1).why  # type: ignore[union-attr]


def test_handles_say_how_far_they_go() -> None:
    desk = Desk('wait 1s\nshow smile 40% for 2s\nlook away\nsay "Hello."\n    on "hello": nod\n')
    assert desk.drags.handles(desk.act("show")) == {
        "start": {"least": 0.0, "most": 2.99},
        "body": {"least": 0.0, "most": 14400.0},
        "end": {"least": 1.01, "most": 14400.0},
        "degree": {"least": 0.0, "most": 1.0, "now": 0.4, "unit": "1"},
    }
    assert set(desk.drags.handles(desk.act("say"))) == {"start", "body"}
    assert set(desk.drags.handles(desk.act("nod"))) == {"end", "degree"}
