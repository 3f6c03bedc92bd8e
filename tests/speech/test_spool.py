"""Sound that is kept in a file: it is what was given, from everywhere, and the first of it stays in memory."""

from __future__ import annotations

import os
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest
from saying import line

from facescript.speech.model import Spoken
from facescript.speech.spool import Kept, Spool
from facescript.speech.studio import Studio
from facescript.world import World

SOUNDS = [bytes([number]) * (1000 + number) for number in range(200)]


def read(kept: bytes | Kept) -> bytes:
    return Spoken(kept, 22_050, 1.0, (), ()).pcm


def test_the_first_stays_in_memory_and_all_is_what_it_was() -> None:
    spool = Spool(held=1500)
    kept = [spool.keep(sound) for sound in SOUNDS]
    assert [isinstance(each, bytes) for each in kept[:3]] == [True, False, False]
    assert [len(each) for each in kept] == [len(sound) for sound in SOUNDS]
    assert [read(each) for each in reversed(kept)] == SOUNDS[::-1]


def test_threads_and_forks_read_at_once() -> None:
    spool = Spool(held=0)
    kept = [spool.keep(sound) for sound in SOUNDS]
    with ThreadPoolExecutor(8) as pool:
        assert list(pool.map(read, kept)) == SOUNDS
    child = os.fork()
    if child == 0:
        os._exit(0 if [read(each) for each in kept] == SOUNDS else 1)
    assert [read(each) for each in kept] == SOUNDS
    assert os.waitpid(child, 0)[1] == 0


def test_where_the_disk_takes_nothing_it_stays_in_memory(monkeypatch: pytest.MonkeyPatch) -> None:
    def full(**options: str) -> None:
        raise OSError(28, "no space left")

    monkeypatch.setattr(tempfile, "TemporaryFile", full)
    assert Spool(held=0).keep(b"sound") == b"sound"


def test_lines_of_a_project_are_kept_so(tmp_path: Path) -> None:
    class Long:
        def speak(self, line: object) -> Spoken:
            return Spoken(bytes(20 * 1024 * 1024), 22_050, 475.0, (), ())

    studio = Studio(World(tmp_path), Long())
    spoken = [studio.speak(line("Hello.")) for _ in range(3)]
    assert [isinstance(each.sound, bytes) for each in spoken] == [True, False, False]
    assert all(len(each.pcm) == 20 * 1024 * 1024 for each in spoken)
