"""What bad input gets: a code, a place and a fix, exit 1, no traceback, and what stood at the output's place."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

BAD = {
    "empty": b"",
    "binary": bytes(range(256)) * 8,
    "not-utf8": 'say "caf\xe9"\n'.encode("latin-1"),
    "tabs": b'scene a:\n\tsay "x"\n        say "y"\n',
    "unclosed": b'say "Hello.\n',
    "unknown-face": b'face ada = woman\nscene a:\n    bob: say "x"\n',
    "unknown-expression": b"show smlie\n",
    "missing-unit": b"wait 300\n",
    "wrong-unit": b"wait 3cm\n",
    "circle-of-times": b'scene a:\n    at b.end: nod as a1\n    at a1.end: say "x" as b\n',
    "action-calls-itself": b"action a:\n    b\naction b:\n    a\na\n",
    "endless-repeat": b"repeat 1000000000 times:\n    nod\n",
    "outside": b'use "../../x.face"\nnod\n',
    "circle-of-use": b'use "script.face"\nnod\n',
}


def facescript(*words: str, cwd: Path) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "facescript.cli.main", *words]
    return subprocess.run(command, cwd=cwd, capture_output=True, text=True, check=False, timeout=120)


@pytest.mark.parametrize("kind", BAD)
def test_bad_script(kind: str, tmp_path: Path) -> None:
    (tmp_path / "script.face").write_bytes(BAD[kind])
    (tmp_path / "out.svg").write_text("as it was")
    for words in (("check", "script.face"), ("build", "script.face", "-o", "out.svg")):
        done = facescript(*words, cwd=tmp_path)
        assert done.returncode == 1, done.stderr
        assert "Traceback" not in done.stderr
        assert "FS" in done.stderr
        assert "script.face" in done.stderr
    assert (tmp_path / "out.svg").read_text() == "as it was"
    assert sorted(os.listdir(tmp_path)) == ["out.svg", "script.face"]


def test_missing_file(tmp_path: Path) -> None:
    done = facescript("build", "nowhere.face", cwd=tmp_path)
    assert (done.returncode, "nowhere.face" in done.stderr, "Traceback" in done.stderr) == (1, True, False)


def test_path_that_cannot_be_written(tmp_path: Path) -> None:
    (tmp_path / "script.face").write_text("nod\n")
    (tmp_path / "folder.json").mkdir()
    for target in ("missing/out.json", "folder.json"):
        done = facescript("build", "script.face", "-o", target, cwd=tmp_path)
        assert (done.returncode, "FS903" in done.stderr, "Traceback" in done.stderr) == (1, True, False)


def test_target_behind_the_head_is_a_warning_and_a_film(tmp_path: Path) -> None:
    (tmp_path / "script.face").write_text("target behind at 170deg 0deg 2m\nlook at behind\nwait 300ms\n")
    done = facescript("build", "script.face", "-o", "out.csv", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    assert "warning" in done.stderr
    assert "80deg beyond" in done.stderr
    assert (tmp_path / "out.csv").stat().st_size > 1000


INERT = ("<script>alert(1)</script>", "a ]]> b", "a ' b & c", "\u05e9\u05dc\u05d5\u05dd", "e\u0301")


def test_texts_are_inert_in_svg(tmp_path: Path) -> None:
    from lxml import etree

    (tmp_path / "script.face").write_text("".join(f'say "{text}", rate 200%\n' for text in INERT), "utf-8")
    done = facescript("build", "script.face", "-o", "out.svg", "--size", "160x160", cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    tree = etree.parse(str(tmp_path / "out.svg"))
    told = "".join(tree.find("{http://www.w3.org/2000/svg}desc").itertext())
    assert all(text in told for text in INERT)
    scripts = tree.findall(".//{http://www.w3.org/2000/svg}script")
    assert all("alert(1)" not in (script.text or "") for script in scripts)


def test_thirty_faults_give_thirty_diagnostics(tmp_path: Path) -> None:
    lines = ["face ada = woman", "scene a:"]
    for number in range(10):
        lines += [
            f"    show nothing{number}",
            "    nod 30%",
            f"    wait {number + 1}",
            f"    lok at camera, fast{number}",
        ]
    (tmp_path / "script.face").write_text("\n".join(lines) + "\n")
    done = facescript("check", "--json", "script.face", cwd=tmp_path)
    import json

    found = json.loads(done.stdout)
    assert len([item for item in found if item["severity"] == "error"]) == 30
    assert len({item["line"] for item in found}) == 30
