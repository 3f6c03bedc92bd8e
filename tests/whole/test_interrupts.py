"""A build that is interrupted, or whose disk is full: what stood there stands, and nothing half-written is left."""

from __future__ import annotations

import os
import resource
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

from facescript.backends.output import outputs

COMMAND = [sys.executable, "-m", "facescript.cli.main", "build", "script.face", "--quiet"]
SCRIPT = 'film 640x360\nface ada = woman\nscene a:\n    show smile\n    say "Good evening, everyone."\n    nod\n'
OLD = b"as it was"


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "script.face").write_text(SCRIPT)
    return tmp_path


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("kind", ["mp4", "svg"])
@pytest.mark.parametrize("delay", [0.45, 0.7, 1.0])
def test_interrupted(folder: Path, kind: str, delay: float, number: int) -> None:
    target = folder / f"film.{kind}"
    target.write_bytes(OLD)
    process = subprocess.Popen([*COMMAND, "-o", target.name], cwd=folder, stderr=subprocess.PIPE, text=True)
    time.sleep(delay)
    process.send_signal(number)
    _, said = process.communicate(timeout=60)
    assert "Traceback" not in said
    assert process.returncode in (0, 130, -number), said
    assert (target.read_bytes() == OLD) == (process.returncode != 0)
    assert sorted(os.listdir(folder)) == sorted([target.name, "script.face"])


@pytest.mark.parametrize("kind", ["mp4", "webm", "gif", "svg", "csv", "jsonl", "wav", "png"])
def test_full_disk(folder: Path, kind: str) -> None:
    """The disk is full after four KiB, by the system's limit of a file's size."""
    target = folder / f"film.{kind}"
    target.write_bytes(OLD)
    done = subprocess.run(
        [*COMMAND, "-o", target.name],
        cwd=folder,
        capture_output=True,
        text=True,
        timeout=120,
        check=False,
        preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (4096, 4096)),
    )
    assert done.returncode == 1, done.stderr
    assert "Traceback" not in done.stderr
    assert "FS90" in done.stderr
    assert target.read_bytes() == OLD
    assert sorted(os.listdir(folder)) == sorted([target.name, "script.face"])


def test_an_interrupt_as_a_file_is_made_leaves_none(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    made = Path.touch

    def interrupted(path: Path, *words: object, **options: object) -> None:
        made(path, *words, **options)
        raise KeyboardInterrupt

    monkeypatch.setattr(Path, "touch", interrupted)
    with pytest.raises(KeyboardInterrupt), outputs() as batch:
        batch.place(tmp_path / "film.svg")
    assert os.listdir(tmp_path) == []


def test_an_interrupt_where_nothing_is_let_through_comes_again() -> None:
    """As where a process is forked: what is raised there is only told of, and lost."""
    program = (
        "import time, facescript.cli.main as main\n"
        "class Forked:\n"
        "    def __del__(self): raise main.Interrupted\n"
        "def run(options):\n"
        "    Forked()\n"
        "    time.sleep(30)\n"
        "main._run = run\n"
        "raise SystemExit(main.main(['list', 'faces']))\n"
    )
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=60, check=False)
    assert (done.returncode, done.stderr) == (130, "facescript: interrupted; nothing was written\n")
