"""The tutorial, the how-tos and the chapters beside them do what they say: their files are written, their commands run."""

from __future__ import annotations

import re
import shlex
import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import pytest

from facescript import __version__
from facescript.cli.arguments import LATER, parser
from facescript.cli.main import main

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = [DOCS / "tutorial.md", *sorted(DOCS.glob("howto/*.md")), DOCS / "backends.md", DOCS / "trouble.md"]

FENCE = re.compile(r"^```([\w-]*)([^\n]*)\n(.*?)^```$", re.MULTILINE | re.DOTALL)
NAMED = re.compile(r"# ([\w-]+\.face)\b")
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
    """The commands of FaceScript in a block, each behind `$`, with the lines that stand below it."""
    for part in re.split(r"^\$ ", text.replace("\\\n", ""), flags=re.MULTILINE)[1:]:
        command, *answer = part.splitlines()
        for piece in command.split(" | "):
            words = shlex.split(piece.partition(" > ")[0])
            if words[:1] == ["facescript"]:
                yield Run(words[1:], answer)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_can_be_followed(page: Path) -> None:
    for step in steps(page):
        if isinstance(step, Run) and step.words[0] not in LATER:
            parser(__version__).parse_args(step.words)


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.stem)
def test_commands_answer_what_the_page_shows(
    page: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    shutil.copytree(ROOT / "examples", tmp_path, dirs_exist_ok=True)
    monkeypatch.chdir(tmp_path)
    nameless = None
    for step in steps(page):
        if isinstance(step, Written):
            nameless = step.text if step.name is None else None
            if step.name is not None:
                Path(step.name).write_text(step.text, "utf-8")
            continue
        if nameless is not None:
            for name in [word for word in step.words if word.endswith(".face")][:1]:
                Path(name).write_text(nameless, "utf-8")
        if step.answer:
            main(step.words)
            said = capsys.readouterr()
            assert fits(step.answer, (said.err + said.out).splitlines()), (step.words, said.err + said.out)


def fits(shown: list[str], said: list[str]) -> bool:
    """Whether the lines are those that are shown, where `...` alone stands for any."""
    wanted = "\n".join(r"(?:[^\n]*\n?)*?" if line == "..." else re.escape(line.rstrip()) for line in shown)
    return re.fullmatch(wanted, "\n".join(line.rstrip() for line in said)) is not None
