"""A script to one page: its text is in it, and what cannot be made says why."""

from __future__ import annotations

import asyncio
import json
from pathlib import Path

import pytest
from lxml import html

from facescript.backends.job import JobFailure
from facescript.preview import share
from facescript.preview.share import shared
from facescript.text import Source
from facescript.world import World

SCRIPT = 'film 64x64\nuse "other.face"\nada: nod for 200ms\n'


@pytest.fixture
def world(tmp_path: Path) -> World:
    (tmp_path / "other.face").write_text("face ada = woman\n", "utf-8")
    return World(tmp_path)


def test_a_page_has_its_script(world: World) -> None:
    found = html.fromstring(shared(world, Source("scratch.face", SCRIPT)))
    assert found.xpath("//pre")[0].text == SCRIPT


async def test_one_at_a_time_and_the_last_one_stays(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    async def made(root: Path, name: str, script: str, target: Path) -> str:
        await asyncio.sleep(0.01)
        target.write_text(script)
        return "it is too long" if script == "bad" else ""

    monkeypatch.setattr(share, "_made", made)
    told: list[bytes] = []
    sharing = share.Sharing(tmp_path, "scratch.face", tmp_path)
    for script in ("one", "at once", "bad", "two"):
        sharing.share(script, told.append)
        await asyncio.sleep(0 if script == "one" else 0.03)
    said = [json.loads(message) for message in told]
    assert [message.get("why") or message["url"] for message in said] == [
        "a page is being made already",
        "shared/1.html",
        "it is too long",
        "shared/2.html",
    ]
    assert not (tmp_path / "1.html").exists() and (tmp_path / "2.html").read_text() == "two"


@pytest.mark.parametrize(
    ("script", "why"),
    [("ada: shw\n", "the script has an error, FS"), ("film 64x64\n", "nothing is played")],
)
def test_what_cannot_be_shared_says_why(world: World, script: str, why: str) -> None:
    with pytest.raises(JobFailure, match=why):
        shared(world, Source("scratch.face", script))
