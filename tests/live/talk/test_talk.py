"""Programs talk to a face that runs: by a WebSocket, with what becomes of it told back."""

from __future__ import annotations

import asyncio
import json
import re
import subprocess
import sys
from collections.abc import AsyncIterator
from pathlib import Path

import pytest
from talking import Notes, talked_to
from websockets.asyncio.client import connect as open_socket

from facescript.live.address import AddressFault, parse
from facescript.live.ports import check_reach
from facescript.live.sources.talk import FORM
from facescript.live.talk import Refusal, connect, connect_plain

ROOT = Path(__file__).parents[3]

pytestmark = pytest.mark.usefixtures("synthesiser")


@pytest.fixture(scope="module")
def synthesiser() -> None:
    pytest.importorskip("espeakng_loader")


def port_of(place: str) -> str:
    found = re.search(r":(\d+)/", place)
    assert found is not None
    return f"talk://127.0.0.1:{found[1]}"


def lines(notes: Notes) -> list[tuple[str, float]]:
    return [(mark.text, mark.time) for mark in notes.marks if mark.kind == "line"]


async def pieces(text: str) -> AsyncIterator[str]:
    for word in text.split(" "):
        await asyncio.sleep(0)
        yield f"{word} "


async def test_what_speaks_waits_its_turn_and_all_else_is_done_at_once() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, notes, _), connect(port_of(place)) as talk:
        ada = talk.face()
        first, second = await ada.say("One."), await ada.say("Two.")
        looked = await ada.look("lamp", eyes_only=True)
        assert await looked.over() == "done"
        assert await first.over() == "said" and await second.over() == "said"
        (one, begun), (two, then) = lines(notes)
        assert (one, two) == ("One.", "Two.")
        ended = begun + next(said.spoken.duration for said in notes.utterances)
        assert then - ended == pytest.approx(0.25, abs=0.11)
        at = next(mark.time for mark in notes.marks if mark.text.startswith("look at lamp"))
        assert at < then
        assert await ada.speaking() is None


async def test_a_streamed_text_is_said_sentence_by_sentence_and_its_signs_are_its_own() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, notes, _), connect(port_of(place)) as talk:
        line = await talk.face("ada").say_stream(pieces("It is *so*. [nod] Yes!"))
        assert await line.over() == "said"
        assert [text for text, _ in lines(notes)] == ["It is *so*.", "[nod] Yes!"]
        assert not [mark for mark in notes.marks if mark.kind == "act" and mark.text.startswith("nod")]


async def test_an_interrupted_line_breaks_off_and_what_waits_is_dropped() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, notes, _), connect(port_of(place)) as talk:
        ada = talk.face()
        long, waiting = await ada.say("This goes on and on, and on, and on, and on."), await ada.say("Never said.")
        while not await ada.speaking():
            await asyncio.sleep(0.02)
        await asyncio.sleep(0.3)
        await ada.interrupt()
        assert await waiting.over() == "interrupted" and await long.over() == "interrupted"
        last = notes.utterances[-1]
        assert last.cut is not None and last.cut < last.start + last.spoken.duration - 0.5
        ends = [word.end for word in last.spoken.words]
        assert min(abs(last.cut - last.start - end) for end in ends) < 0.06
        assert [text for text, _ in lines(notes)] == ["This goes on and on, and on, and on, and on."]


async def test_what_is_told_with_now_does_not_wait() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, notes, _), connect(port_of(place)) as talk:
        long = await talk.do('say "This goes on and on, and on, and on, and on."')
        while not await talk.speaking():
            await asyncio.sleep(0.02)
        short = await talk.do('say "Stop."', now=True)
        assert [await long.over(), await short.over()] == ["interrupted", "said"]
        (_, begun), (text, then) = lines(notes)
        assert text == "Stop." and then - begun < 1.0


async def test_a_flood_of_statements_is_refused_and_told() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, _, gate), connect(port_of(place)) as talk:
        found = await asyncio.gather(*(talk.do(f"look left {n + 1}deg") for n in range(300)), return_exceptions=True)
        refused = [one for one in found if isinstance(one, Refusal)]
        assert refused and {one.diagnostics[0]["code"] for one in refused} == {"FS995"}
        assert sum(gate.counts().values()) == 300


async def test_what_is_wrong_is_told_with_its_diagnostic() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, _, _), connect(port_of(place)) as talk:
        with pytest.raises(Refusal) as refused:
            await talk.face("ada").look("lump")
        (diagnostic,) = refused.value.diagnostics
        assert diagnostic["code"] == "FS202" and diagnostic["column"] == 14
        with pytest.raises(Refusal, match="no file"):
            await talk.do('say "x" from "x.wav"')


async def test_nonsense_is_answered_and_costs_nothing() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, _, _):
        address = port_of(place).replace("talk", "ws", 1) + "/talk"
        async with open_socket(address) as socket:
            for said in ("x", "[]", '{"do": 1}', '{"do": "nod", "ask": ""}', '{"id": [], "do": "nod"}', b"\xff"):
                await socket.send(said)
                assert "such as" in json.loads(await socket.recv())["refused"]
            await socket.send('{"id": "a", "do": "nod"}')
            assert json.loads(await socket.recv()) == {"id": "a", "taken": True, "speaks": False}


async def test_a_program_hears_what_begins() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, _, _), connect(port_of(place)) as talk:
        await talk.face().say("Good day.")
        words = []
        async for mark in talk.marks():
            words += [mark["word"]] if "word" in mark else []
            if len(words) == 2:
                break
        assert words == ["Good", "day"]


async def test_a_program_that_waits_talks_too() -> None:
    def plain(address: str) -> list[str]:
        with connect_plain(address) as talk:
            ada = talk.face()
            ada.show("smile 60%", over=0.2)
            told = [ada.say("Hi.").over(), ada.say_stream(["I ", "am. "]).over()]
            return [*told, str(ada.speaking())]

    async with talked_to("talk://127.0.0.1:0") as (place, _, _):
        assert await asyncio.to_thread(plain, port_of(place)) == ["said", "said", "None"]


async def test_the_example_gives_answers_a_face() -> None:
    async with talked_to("talk://127.0.0.1:0") as (place, notes, _):
        words = [sys.executable, str(ROOT / "examples" / "partner.py"), port_of(place)]
        told = await asyncio.to_thread(
            subprocess.run, words, input="What is this?\n\n", capture_output=True, text=True, timeout=30
        )
        assert told.stdout.split() == ["said"], told.stderr
        assert [text for text, _ in lines(notes)] == ["I see.", "Tell me more about that, please."]


def test_who_listens_beyond_this_machine_asks_for_a_token() -> None:
    with pytest.raises(AddressFault) as refused:
        check_reach(parse("talk://0.0.0.0:8770", FORM), "")
    assert refused.value.code == "FS983"
    check_reach(parse("talk://0.0.0.0:8770", FORM), "word")
