"""The tutorial, the how-tos and the chapters beside them do what they say: their files are written, commands run."""

from __future__ import annotations

import re
import runpy
import shlex
import shutil
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby, pairwise, takewhile
from pathlib import Path

import pytest

import facescript
from facescript import __version__
from facescript.cli.arguments import parser
from facescript.cli.main import main
from facescript.syntax.formatter import format_source
from facescript.text import Source

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
CHAPTERS = [DOCS / f"{name}.md" for name in ("backends", "live", "trouble")]
PAGES = [DOCS / "tutorial.md", *sorted(DOCS.glob("howto/*.md")), *CHAPTERS]

FENCE = re.compile(r"^```([\w-]*)([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"# ([\w-]+\.face)\b")
CHEAP = (".bvh", ".jsonl", ".json", ".face", ".wav", ".vtt")
"""Outputs that are made here too, not only those whose answer a page shows."""

TITLED = re.compile(r'title="([^"]+)"')


@dataclass(frozen=True, slots=True)
class Run:
    """A command of a page and what the page says that it answers."""

    words: list[str]
    answer: list[str]


@dataclass(frozen=True, slots=True)
class Written:
    """A file of a page. One without a name is the script that the next command names."""

    name: str | None
    text: str


def steps(page: Path) -> Iterator[Run | Written]:
    """What a reader of the page does, in order."""
    for kind, attributes, text in FENCE.findall(page.read_text("utf-8")):
        named, titled = NAMED.match(text), TITLED.search(attributes)
        if titled or kind in ("face", "face-bad"):
            yield Written(titled[1] if titled else named[1] if named else None, text)
        elif kind == "console":
            yield from commands(text)


def commands(text: str) -> Iterator[Run]:
    """The commands in a block that can be followed here, each behind `$`, with the lines that stand below it."""
    for part in re.split(r"^\$ ", text.replace("\\\n", ""), flags=re.MULTILINE)[1:]:
        command, *answer = part.splitlines()
        for pipe, piece in groupby(shlex.split(command), lambda word: word == "|"):
            words = list(takewhile(lambda word: word != ">", piece))
            if not pipe and words[:1] in (["facescript"], ["python"]):
                yield Run(words, answer)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_can_be_followed(page: Path) -> None:
    for step in steps(page):
        if isinstance(step, Run) and step.words[0] == "facescript":
            parser(__version__).parse_args(step.words[1:])


@pytest.mark.parametrize("page", [*PAGES, DOCS / "how-it-moves.md"], ids=lambda page: page.stem)
def test_scripts_are_in_the_layout(page: Path) -> None:
    scripts = [text for kind, _, text in FENCE.findall(page.read_text("utf-8")) if kind == "face"]
    assert [text for text in scripts if format_source(Source(page.name, text)) != text] == []


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_do_what_the_page_shows(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(ROOT / "examples", tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    nameless = None
    for step in steps(page):
        if isinstance(step, Written):
            nameless = step.text if step.name is None else None
            if step.name is not None:
                write(Path(step.name), step.text, monkeypatch)
        else:
            if nameless is not None:
                write(script_of(step), nameless, monkeypatch)
            follow(step, capsys)


def script_of(run: Run) -> Path:
    return Path(next((word for word in run.words if word.endswith(".face")), "nameless.face"))


def write(path: Path, text: str, monkeypatch: pytest.MonkeyPatch) -> None:
    """A file of a page; one that says what a package is made of is installed."""
    path.parent.mkdir(exist_ok=True)
    path.write_text(text, "utf-8")
    if path.name == "pyproject.toml":
        project = tomllib.loads(text)["project"]
        told = Path(f"{project['name'].replace('-', '_')}-{project['version']}.dist-info")
        told.mkdir()
        (told / "METADATA").write_text(f"Name: {project['name']}\nVersion: {project['version']}\n")
        points = [
            f"[{group}]\n" + "".join(f"{name} = {value}\n" for name, value in rows.items())
            for group, rows in project["entry-points"].items()
        ]
        (told / "entry_points.txt").write_text("\n".join(points))
        monkeypatch.syspath_prepend(str(path.parent.resolve()))


def follow(run: Run, capsys: pytest.CaptureFixture[str]) -> None:
    """A command whose answer is shown answers so; one that makes what is cheap to make makes it."""
    if run.words[0] == "python":
        runpy.run_path(run.words[1])
        return
    made = [word for flag, word in pairwise(run.words) if flag == "-o"]
    cheap = bool(made) and all(Path(name).suffix in CHEAP for name in made)
    if not run.answer and not cheap:
        return
    code = main(run.words[1:])
    said = capsys.readouterr()
    told = said.err + said.out
    if run.answer:
        assert fits(run.answer, told.splitlines()), (run.words, told)
    else:
        assert code == 0, (run.words, told)
        assert all(Path(name).stat().st_size for name in made), run.words


def fits(shown: list[str], said: list[str]) -> bool:
    """Whether the lines are those that are shown, where `...` alone stands for any."""
    wanted = "\n".join(".*" if line == "..." else re.escape(line.rstrip()) for line in shown)
    return re.fullmatch(wanted, "\n".join(line.rstrip() for line in said), re.DOTALL) is not None


def test_output_of_the_chapter_on_outputs_turns_the_head(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for step in steps(DOCS / "backends.md"):
        if isinstance(step, Written) and step.name:
            write(Path(step.name), step.text, monkeypatch)
    assert main(["build", "turn.face", "-o", "turn.bvh"]) == 0
    lines = Path("turn.bvh").read_text("ascii").splitlines()
    rows = [[float(number) for number in line.split()] for line in lines[lines.index("MOTION") + 3 :]]
    assert f"Frames: {len(rows)}" in lines
    furthest = max(rows, key=lambda row: row[1])
    pose = facescript.load("turn.face").pose(rows.index(furthest) / 30)
    assert furthest[1] > 20
    turns = [-pose["head.roll"], pose["head.yaw"], -pose["head.pitch"]]
    assert furthest == pytest.approx(turns, abs=1e-3)
