"""The wheel in an empty environment, run from another folder: it finds its grammar and library and makes outputs."""

from __future__ import annotations

import os
import subprocess
import sys
import venv
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


def run(*words: str | Path, cwd: Path) -> str:
    clean = {name: value for name, value in os.environ.items() if not name.startswith(("PYTHON", "VIRTUAL_ENV"))}
    done = subprocess.run(words, cwd=cwd, env=clean, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of an environment's programs, with nothing but the wheel and what it asks for."""
    folder = tmp_path_factory.mktemp("wheel")
    run(sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder / "dist", ROOT, cwd=folder)
    (wheel,) = (folder / "dist").glob("*.whl")
    venv.create(folder / "env", with_pip=True)
    programs = folder / "env" / ("Scripts" if os.name == "nt" else "bin")
    quiet = ("--quiet", "--disable-pip-version-check", "--constraint", ROOT / "constraints.txt")
    run(programs / "python", "-m", "pip", "install", *quiet, wheel, cwd=folder)
    return programs


def test_builds_from_another_folder(installed: Path, tmp_path: Path) -> None:
    (tmp_path / "hello.face").write_text('show smile 60%\nsay "Hello."\n', "utf-8")
    run(installed / "facescript", "check", "hello.face", cwd=tmp_path)
    outputs = ("-o", "hello.json", "-o", "hello.csv", "-o", "hello.wav", "-o", "hello.svg", "-o", "hello.png")
    run(installed / "facescript", "build", "hello.face", *outputs, "--size", "160x160", cwd=tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["hello.face", *outputs[1::2]])


def test_the_package_lies_outside_the_checkout(installed: Path, tmp_path: Path) -> None:
    script = "import facescript, facescript.resources as r; print(facescript.__file__, r.folder('stdlib'))"
    assert str(ROOT) not in run(installed / "python", "-c", script, cwd=tmp_path)


def test_it_brings_the_playgrounds_examples(installed: Path, tmp_path: Path) -> None:
    script = "from facescript.preview.examples import examples; print([each.name for each in examples()][:2])"
    assert run(installed / "python", "-c", script, cwd=tmp_path) == "['hello', 'words']\n"
