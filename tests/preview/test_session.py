"""What the process of a preview makes of a script's states: lines that wait for a voice, frames that are bounded."""

from __future__ import annotations

from pathlib import Path

import pytest
from serving import Message, read

from facescript.preview import frames, voice
from facescript.preview.session import Session

LINE = 'film 320x180\nface ada = woman, hair still\n    life still\nscene a:\n    say "Good evening."\n'


@pytest.fixture
def session(tmp_path: Path) -> Session:
    return Session(tmp_path, "x.face", tmp_path)


def made(session: Session, version: int, text: str) -> list[Message]:
    """All that comes of a text."""
    session.hear({"kind": "text", "version": version, "text": text})
    return done(session)


def done(session: Session) -> list[Message]:
    found = []
    while session.busy:
        found += [read(message if message[:1] != b"{" else message.decode()) for message in session.step()]
    return found


def of(told: list[Message], kind: str) -> list[Message]:
    return [message for message in told if message["kind"] == kind]


def test_a_line_has_estimated_times_until_it_is_spoken(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(voice, "AT_ONCE", 0.0)
    told = made(session, 1, LINE + "    nod\n")
    first, last = of(told, "score")
    assert [any(act["estimated"] for act in score["acts"]) for score in (first, last)] == [True, False]
    order = [message["kind"] for message in told]
    assert order.index("frames") < order.index("sound") < len(order) - 1 - order[::-1].index("score"), (
        "the picture first"
    )
    assert of(told, "sound")[-1]["url"] and max(of(told, "sound")[-1]["peaks"]) > 20


def test_an_edit_comes_before_frames_of_an_older_text(session: Session) -> None:
    text = LINE + "    wait 3s\n"
    session.hear({"kind": "text", "version": 1, "text": text})
    for _ in range(3):
        list(session.step())
    told = made(session, 2, text + "    nod\n")
    assert {message["version"] for message in of(told, "frames")} == {2}


def test_chunks_are_held_around_the_playhead_alone(session: Session, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(frames, "MOST", 3)
    told = made(session, 1, "film 320x180\nface ada = woman, hair still\n    life still\nwait 8s\n")
    assert [message["chunk"] for message in of(told, "frames")] == [0, 1, 2]
    session.hear({"kind": "playhead", "time": 6.2, "playing": False})
    told = done(session)
    held = {0, 1, 2}
    for message in told:
        held |= {message["chunk"]} if message["kind"] == "frames" else set()
        held -= set(message["chunks"]) if message["kind"] == "forget" else set()
    assert held == {5, 6, 7}


def test_a_fault_of_the_compiler_is_not_met_again_and_again(session: Session) -> None:
    session.hear({"kind": "text", "version": 1, "text": LINE})
    session.give_up()
    assert not session.busy
    assert of(made(session, 2, LINE), "score")


def test_an_empty_script_says_that_there_is_nothing_to_play(session: Session) -> None:
    told = made(session, 1, "expression wry = smile.left 60%\n")
    assert [item["code"] for item in of(told, "diagnostics")[0]["items"]] == ["FS911"]
    assert not of(told, "score")
