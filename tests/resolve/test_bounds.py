"""What unfolds too far or stands too deep is told, and one fault does not bring others after it."""

from __future__ import annotations

from pathlib import Path

import pytest
from plays import codes, play_of, resolved, said


def chain(form: str, last: str, count: int, first: str) -> str:
    """Definitions each of which leads to the next."""
    names = [f"b{number}" for number in range(count)]
    rows = [form.format(name=name, next=following) for name, following in zip(names, [*names[1:], last], strict=True)]
    return "".join(rows) + first


OWN = "expression own(x = 1%) = smile x\nshow b0(1%)\n"
CHAINS = {
    "actions": ("action {name}:\n    {next}\n", "nod", "b0\n"),
    "actions by twos": ("action {name}:\n    {next}\n    {next}\n", "nod", "b0\n"),
    "actions that hand on": ("action {name}(x = 1s):\n    {next} x + x\n", "wait", "b0 1ms\n"),
    "lets": ("let {name} = {next} + {next}\n", "1ms", "wait b0\n"),
    "expressions": ("expression {name} = {next} 50% + {next}\n", "smile", "show b0\n"),
    "expressions with parameters": ("expression {name}(x = 1%) = {next}(x + x)\n", "own", OWN),
}


@pytest.mark.parametrize("kind", CHAINS)
@pytest.mark.parametrize("count", [30, 1500])
def test_a_long_chain_of_definitions_is_worked_out_or_refused(kind: str, count: int) -> None:
    form, last, first = CHAINS[kind]
    fine = count == 30 and kind in ("actions", "expressions")
    assert codes(chain(form, last, count, first)) == ([] if fine else ["FS322"])


def test_short_chains_mean_what_they_say() -> None:
    assert play_of(chain("action {name}:\n    {next}\n", "nod", 40, "b0\n"))
    assert play_of(chain("let {name} = {next} + {next}\n", "1ms", 9, "wait b0\n"))


def test_brackets_and_lets_count_together() -> None:
    """Neither is deep by itself."""
    lets = chain("let {name} = " + "(" * 20 + "{next}" + ")" * 20 + "\n", "1s", 20, "wait b0\n")
    assert codes(lets) == ["FS322"]


def test_tables_in_tables_multiply(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("x\n" + "1s\n" * 40)
    rows = "".join("    " * level + f'repeat r{level} in "t.csv":\n' for level in range(9)) + "    " * 9 + "wait r8.x\n"
    assert codes(rows, tmp_path) == ["FS322"]
    assert codes('repeat r in "t.csv":\n    repeat s in "t.csv":\n        wait r.x\n        wait s.x\n', tmp_path) == []


def test_a_table_with_a_fault_is_told_of_once(tmp_path: Path) -> None:
    (tmp_path / "t.csv").write_text("x,x\n1,2\n")
    assert codes('repeat r in "t.csv":\n    nod\nrepeat s in "t.csv":\n    nod\n', tmp_path) == ["FS703", "FS703"]


def test_after_many_faults_nothing_is_proposed_any_more() -> None:
    found = resolved("let beat = 1s\n" + "wait baet\nwait 1s\n" * 300)[1].items
    assert found[0].fixes
    assert not found[-1].fixes


# ------------------------------------------------------------------------------------------------ no cascades


@pytest.mark.parametrize(
    "text",
    [
        "target show at 10deg 0deg 1m\nlook at show\nglance show\n",
        "let camera = 2s\nwait camera\nlook at camera\n",
        "expression nod = smile\nshow nod\nnod\n",
        "action look:\n    nod\nlook\n",
        "face say = woman\nscene one:\n    say: nod\n    say: look at camera\n",
        "action slow(over = 2s):\n    wait over\nslow\n",
        "nod as over\nat over.end: nod\n",
    ],
)
def test_a_word_of_the_language_as_a_name_is_told_once(text: str) -> None:
    assert codes(text) == ["FS209"]


@pytest.mark.parametrize(
    "text",
    [
        "action sw§ing:\n    nod\nswing\n",
        "let be§at = 1s\nwait beat\n",
        "face ada = woman\n\tscene one:\n    ada: nod\n    ada: show smile\n",
        "action greet:\n    nod\n\tscene one:\n    greet\n    greet\n",
        "film 1280x720\nwait § until 2s\nnod\n",
        'say "one two" as hello § \n    on "three": nod\nat hello.end: nod\n',
        "target cup at 0cm 0cm 1m\nscene one: §\n    look at cup\n",
    ],
)
def test_lines_that_could_not_be_read_bring_no_faults_elsewhere(text: str) -> None:
    found = codes(text)
    assert found
    assert all(code < "FS200" for code in found), said(resolved(text)[1])


def test_a_fault_beside_a_spoilt_line_is_still_told() -> None:
    assert "FS201" in codes("wait §\nshow smlie\n")


# ------------------------------------------------------------------------------------------------ names


def test_a_misspelt_side_is_known_again() -> None:
    for name in ("AU1.lft", "smile.lft"):
        (found,) = resolved(f"show {name}\n")[1]
        assert found.fixes[0].edits[0].text == name.replace("lft", "left")


def test_the_face_of_a_script_without_one_has_a_name() -> None:
    play = play_of("view somebody 150%\nsomebody: nod\n")
    assert [face.name for face in play.faces] == ["somebody"]
    assert codes("target somebody at 0cm 0cm 1m\nlook at somebody\n") == []


def test_a_face_stands_whatever_is_named_as_its_life() -> None:
    """The target covers the library's life that a face has where its author names none."""
    assert "FS214" in codes("target calm at 0cm 0cm 1m\nlook at calm\n")
