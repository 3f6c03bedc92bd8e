"""The user's cache: what is kept comes back whole or not at all, is bounded, and is safe to lose."""

from __future__ import annotations

import os
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from facescript.cache import Room

KEY = "0" * 32
ROOM = Room("things", largest=1000, bound=32_000)
THING = {"a": [1]}, b"body \n\0"
POSIX = pytest.mark.skipif(os.name != "posix", reason="modes and links are of posix")


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "facescript" / "things"


def kept(place: Path) -> Path:
    ROOM.save(KEY, *THING)
    (path,) = place.iterdir()
    return path


def test_a_thing_comes_back_as_it_was(place: Path) -> None:
    assert ROOM.load(KEY) is ROOM.head(KEY) is None
    kept(place)
    assert ROOM.load(KEY) == THING
    assert ROOM.head(KEY) == THING[0]


@POSIX
def test_only_the_user_can_write_there(place: Path) -> None:
    path = kept(place)
    assert [stat.S_IMODE(one.stat().st_mode) for one in (place.parent, place, path)] == [0o700, 0o700, 0o600]


def test_a_damaged_file_is_not_believed_and_is_replaced(place: Path) -> None:
    path = kept(place)
    whole = path.read_bytes()
    for damaged in (b"", whole[:-3], whole.replace(b"1]", b"2]"), b"\xff" * 100, whole.replace(b"\n", b"")):
        path.write_bytes(damaged)
        assert ROOM.load(KEY) is None
    path.write_bytes(whole.replace(b"body", b"boda"))
    assert ROOM.load(KEY) is None
    assert ROOM.head(KEY) == THING[0]
    ROOM.save(KEY, *THING)
    assert ROOM.load(KEY) == THING


def test_a_file_under_another_key_is_not_believed(place: Path) -> None:
    other = "1" * 32
    path = kept(place)
    path.rename(path.with_name(other))
    assert ROOM.load(other) is ROOM.load(KEY) is None


@POSIX
def test_what_others_could_have_put_there_is_not_believed(place: Path, tmp_path: Path) -> None:
    path = kept(place)
    for one in (path, place, place.parent):
        mode = stat.S_IMODE(one.stat().st_mode)
        one.chmod(mode | 0o022)
        assert ROOM.load(KEY) is None
        one.chmod(mode)
        assert ROOM.load(KEY) == THING
    path.rename(tmp_path / "elsewhere")
    path.symlink_to(tmp_path / "elsewhere")
    assert ROOM.load(KEY) is None
    path.unlink()
    os.mkfifo(path)
    assert ROOM.load(KEY) is None


def test_without_a_usable_folder_nothing_is_kept(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    ROOM.save(KEY, {})
    assert ROOM.load(KEY) is None


def test_a_relative_or_missing_home_is_no_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("XDG_CACHE_HOME", "here")
    monkeypatch.setenv("LOCALAPPDATA", "")
    monkeypatch.setattr(Path, "home", lambda: Path("nowhere"))
    ROOM.save(KEY, {})
    assert ROOM.load(KEY) is None
    assert list(tmp_path.iterdir()) == []


def test_a_full_disk_leaves_nothing_behind(place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise OSError("no space left on device")

    monkeypatch.setattr(os, "replace", refuse)
    ROOM.save(KEY, {"a": [1]})
    assert list(place.iterdir()) == []


def test_what_was_used_longest_ago_goes_first(place: Path) -> None:
    for number in range(60):
        ROOM.save(f"{number:032}", {}, bytes(900))
        os.utime(place / f"{number:032}", ns=(number * 10**9, number * 10**9))
        assert ROOM.load(KEY) is not None  # it is used all the time
    assert sum(path.stat().st_size for path in place.iterdir()) <= 33_000
    assert ROOM.load(f"{59:032}") is not None
    assert ROOM.load(f"{1:032}") is None
    ROOM.save("1" * 32, {}, bytes(2000))
    assert ROOM.load("1" * 32) is None  # larger than one thing may be


def test_many_write_and_read_at_once(place: Path) -> None:
    program = (
        "from facescript.cache import Room; room = Room('things', 100_000, 150_000)\n"
        "for n in range(150):\n"
        "    key = str(n % 5) * 32; room.save(key, n % 5, bytes([n % 5]) * 50_000); found = room.load(key)\n"
        "    assert found in (None, (n % 5, bytes([n % 5]) * 50_000)), found\n"
    )
    running = [subprocess.Popen([sys.executable, "-c", program]) for _ in range(3)]
    assert [process.wait() for process in running] == [0, 0, 0]
    assert not list(place.glob("*.part"))
