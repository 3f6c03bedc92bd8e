"""`facescript preview` on the command line: what it refuses, and how it ends."""

from __future__ import annotations

import json
import os
import re
import signal
import socket
import subprocess
import sys
from pathlib import Path

import pytest
from websockets.sync.client import connect

from facescript.cli import preview
from facescript.cli.main import main


@pytest.fixture
def script(tmp_path: Path) -> str:
    (tmp_path / "x.face").write_text("nod\n", "utf-8")
    return str(tmp_path / "x.face")


def test_a_port_that_is_taken_is_told(script: str, capsys: pytest.CaptureFixture[str]) -> None:
    with socket.socket() as other:
        other.bind(("127.0.0.1", 0))
        other.listen()
        assert main(["preview", script, "--port", str(other.getsockname()[1])]) == 2
    assert "FS967" in capsys.readouterr().err


@pytest.mark.parametrize("port", ["x", "-1", "70000", "1.5"])
def test_a_port_that_is_none_is_told(script: str, port: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["preview", script, f"--port={port}"]) == 2
    assert "FS904" in capsys.readouterr().err


def test_a_script_that_is_not_there_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["preview", "missing.face"]) == 1
    assert "FS901" in capsys.readouterr().err


def test_without_its_extra_it_says_how_to_get_it(
    script: str, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(preview, "find_spec", lambda name: None)
    assert main(["preview", script]) == 2
    assert 'pip install "facescript[preview]"' in capsys.readouterr().err


def test_it_shows_standard_input_and_ends_quietly(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "facescript.cli.main", "preview", "-", "--port", "0"]
    pipe = subprocess.PIPE
    process = subprocess.Popen(command, cwd=tmp_path, stdin=pipe, stdout=pipe, stderr=pipe, env=dict(os.environ))
    try:
        assert process.stdin is not None and process.stdout is not None
        process.stdin.write(b"nod\n")
        process.stdin.close()
        found = re.search(rb"127\.0\.0\.1:(\d+)", process.stdout.readline())
        assert found is not None
        with connect(f"ws://127.0.0.1:{int(found[1])}/live", legacy=True) as page:
            told = [json.loads(page.recv(timeout=20)) for _ in range(2)]
        script = next(message for message in told if message["kind"] == "script")
        assert (script["text"], script["writable"]) == ("nod\n", False)
        process.send_signal(signal.SIGINT)
        assert process.wait(timeout=20) == 0
        assert process.stderr is not None and process.stderr.read() == b""
    finally:
        process.kill()
        process.wait()
