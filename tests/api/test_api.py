"""Takes and scripts as a program uses them; the examples in the documentation are run."""

from __future__ import annotations

import doctest
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

import numpy as np
import pytest
from lxml import html

import facescript
from facescript import Script, ScriptFault

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.mark.parametrize("name", ["take", "script"])
def test_examples_in_the_documentation_are_right(name: str) -> None:
    found = doctest.testmod(import_module(f"facescript.api.{name}"))
    assert found.attempted > 0 and found.failed == 0


def test_the_package_is_imported_without_numpy_or_a_compiler() -> None:
    program = "import sys, facescript; print([name for name in ('numpy', 'lark', 'pydantic') if name in sys.modules])"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, check=True)
    assert done.stdout.strip() == "[]"


def test_a_take_is_asked_by_name_and_by_time() -> None:
    take = facescript.load(EXAMPLES / "dialogue.face")
    assert len(take.faces) == 2 and all(name.split(".")[0] in take.faces for name in take.channels)
    times = [0.5, 0.1, take.duration]
    table = take.sample(times)
    assert table["time"].tolist() == times
    for row, time in enumerate(times):
        assert {name: table[name][row] for name in take.channels} == take.pose(time)
    assert any(row["kind"] == "word" for row in take.explain())


def test_another_seed_or_value_is_another_take() -> None:
    text = "let degree = 20%\nfilm seed 1\nshow smile degree\nwait 1s\n"
    usual = facescript.loads(text)
    assert facescript.loads(text, seed=1).pose(1.0) == usual.pose(1.0)
    stronger = facescript.loads(text, values={"degree": "80%"})
    assert stronger.pose(1.0)["cheek.lower.left"] > 2 * usual.pose(1.0)["cheek.lower.left"]


def test_a_fault_has_its_place_and_no_traceback_of_the_compiler(tmp_path: Path) -> None:
    with pytest.raises(ScriptFault, match=re.escape("script.face:1:6")) as told:
        facescript.loads("show smlie 60%\n")
    assert [item.code for item in told.value.diagnostics] == ["FS201"]
    with pytest.raises(ScriptFault, match="there is no such file"):
        facescript.load(tmp_path / "none.face")


def test_files_are_written_and_what_cannot_be_is_refused(tmp_path: Path) -> None:
    take = facescript.loads("film 160x160\nnod\nwait 300ms\n")
    assert take.save(tmp_path / "a.csv").read_text().startswith("time,")
    assert take.save(tmp_path / "a.png", at=0.1).stat().st_size > 1000
    for path, words in (("a.xyz", {}), ("a.csv", {"at": 0.1}), ("a.csv", {"start": 2.0}), ("a.csv", {"end": 9.0})):
        with pytest.raises(ValueError, match=r"kind|moment|long"):
            take.save(tmp_path / path, **words)


def test_a_notebook_shows_it_playing() -> None:
    take = facescript.loads("film 160x120\nnod\nwait 200ms\n")
    (frame,) = html.fromstring(f"<div>{take._repr_html_()}</div>").xpath("//iframe")
    assert frame.get("src").startswith("data:image/svg+xml;base64,")
    assert (frame.get("width"), frame.get("height")) == ("160", "120")


def test_a_script_is_written_call_by_call() -> None:
    script = Script(size="320x240", seed=2, title='A "film"')
    ada, bob = script.face("ada", voice="en-us", blink=12, size=0.8), script.face("bob", "man")
    with script.scene("first", "One \\ two"):
        with script.together():
            ada.look(bob, for_=1.5, eyes_only=True)
            bob.show("smile 60%", over=0.25, as_="happy")
        with script.repeat(2):
            bob.nod(0.4)
        with script.together():
            pass
        script.wait(0.5)
    assert (
        script.text
        == """\
film 320x240, seed 2, title "A \\"film\\""
face ada = woman, voice en-us, blink 12/min, size 80%
face bob = man
scene first "One \\\\ two":
    together:
        ada: look at bob for 1.5s, eyes only
        bob: show smile 60% over 0.25s as happy
    repeat 2 times:
        bob: nod 40%
    wait 0.5s
"""
    )
    take = script.take()
    assert take.faces == ("ada", "bob") and take.duration > 1.0


@pytest.mark.parametrize("words", [{"ovr": 1}, {"eyes_only": 0.5}, {"over": True}])
def test_a_keyword_that_is_no_modifier_is_refused(words: dict[str, object]) -> None:
    ada = Script().face("ada")
    with pytest.raises(TypeError):
        ada.look("camera", **words)  # type: ignore[arg-type]


def test_what_a_text_says_is_what_is_said() -> None:
    script = Script()
    script.face("ada", voice="en-us").say('He said "no\\yes",\nand left.')
    (row,) = [row for row in script.take().explain() if row["kind"] == "line"]
    assert np.isfinite(float(str(row["start"]))) and 'He said "no' in str(row["what"])
