"""Edits that a page makes in the script's file: the smallest, only where the file is what the page saw, taken back."""

from __future__ import annotations

from pathlib import Path

import pytest

from facescript.preview.paper import Edit, Paper, Refusal

TEXT = 'say "Ah 😀."\nwait 1s\n'


@pytest.fixture
def paper(tmp_path: Path) -> Paper:
    path = tmp_path / "x.face"
    path.write_bytes(b"\xef\xbb\xbf" + TEXT.replace("\n", "\r\n").encode())
    return Paper(path, TEXT)


def written(paper: Paper) -> bytes:
    assert paper.path is not None
    return paper.path.read_bytes()


def test_an_edit_keeps_the_line_ends_and_the_mark_of_the_file(paper: Paper) -> None:
    at = TEXT.index("1s") + 1  # the smile is two units
    paper.edit(1, Edit(at, at + 1, "25"))
    assert written(paper) == b"\xef\xbb\xbf" + TEXT.replace("1s", "25s").replace("\n", "\r\n").encode()
    assert (paper.version, paper.text) == (2, TEXT.replace("1s", "25s"))


def test_edits_are_taken_back_one_by_one(paper: Paper) -> None:
    before = written(paper)
    paper.edit(1, Edit(0, 0, "nod\n"))
    paper.edit(2, Edit(0, 0, "blink\n"))
    assert paper.undo() == Edit(0, 6, "")
    assert paper.undo() == Edit(0, 4, "")
    assert written(paper) == before
    with pytest.raises(Refusal, match="nothing"):
        paper.undo()


def test_an_edit_of_an_older_text_is_refused(paper: Paper) -> None:
    paper.edit(1, Edit(0, 0, "nod\n"))
    with pytest.raises(Refusal, match="changed since"):
        paper.edit(1, Edit(0, 0, "nod\n"))


def test_nothing_is_written_over_what_another_program_wrote(paper: Paper) -> None:
    assert paper.path is not None
    paper.path.write_text("nod\n", "utf-8")
    with pytest.raises(Refusal, match="changed since"):
        paper.edit(1, Edit(0, 0, "blink\n"))
    assert written(paper) == b"nod\n"
    assert paper.read() and paper.text == "nod\n"


@pytest.mark.parametrize(
    "edit", [Edit(5, 4, ""), Edit(-1, 0, ""), Edit(0, 999, ""), Edit(0, 0, "\0"), Edit(0, 0, "\ud800")]
)
def test_what_cannot_be_is_refused(paper: Paper, edit: Edit) -> None:
    before = written(paper)
    with pytest.raises(Refusal):
        paper.edit(1, edit)
    assert written(paper) == before and paper.version == 1


def test_what_was_read_from_standard_input_stays() -> None:
    with pytest.raises(Refusal, match="standard input"):
        Paper(None, TEXT).edit(1, Edit(0, 0, ""))


def test_what_is_taken_back_is_the_text_the_page_made(paper: Paper) -> None:
    paper.edit(1, Edit(0, 0, "nod\n"))
    paper.take("blink\n")
    with pytest.raises(Refusal, match="elsewhere"):
        paper.undo()
