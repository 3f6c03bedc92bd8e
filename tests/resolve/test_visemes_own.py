"""`viseme "SOUND" = ...`: from a script to the mouth, and what is said where it cannot be read."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from facescript.compile import Compiled, compile_source
from facescript.ir.acts import Say
from facescript.ir.json_form import dump, load
from facescript.motion.perform import perform
from facescript.speech.model import PhoneTime, Spoken
from facescript.speech.mouth.own import table_of
from facescript.text import Source
from facescript.world import World


class Speller:
    """A voice that has a sound of 0.2 s for every letter."""

    def speak(self, line: Say) -> Spoken:
        phones = [PhoneTime(sign, 0.2 * at, 0.2 * (at + 1), True) for at, sign in enumerate(line.text.strip("."))]
        return Spoken(b"", 22_050, 0.2 * len(phones), (), tuple(phones))


def compiled(text: str, folder: Path) -> Compiled:
    return compile_source(Source("script.face", text), World(folder), Speller())


def codes(text: str, folder: Path) -> list[str]:
    return [item.code for item in compiled(text, folder).diagnostics]


def test_a_sound_is_as_another_one(tmp_path: Path) -> None:
    made = compiled('viseme "θ" = "f"\nsay "aθa."\n', tmp_path)
    assert made.score is not None
    pose = perform(made.score).pose(made.score.lines[0].start + 0.3)
    assert pose["mouth.open"] == 0.0 and pose["mouth.lower"] == pytest.approx(-0.2)


def test_a_sound_has_a_shape_of_its_own(tmp_path: Path) -> None:
    shape = "mouth.upper 10% + mouth.lower 20% + mouth.round 50%"
    made = compiled(f'life still\nviseme "s" = {shape}\nsay "asa."\n', tmp_path)
    assert made.score is not None
    pose = perform(made.score).pose(made.score.lines[0].start + 0.3)
    found = [pose[f"mouth.{part}"] for part in ("open", "upper", "lower", "round")]
    assert found == pytest.approx([0.3, 0.1, 0.2, 0.5], abs=1e-6)


def test_a_degree_scales_and_a_group_of_letters_is_one_sound(tmp_path: Path) -> None:
    made = compiled('viseme "tʃ" = "s" 50%\nviseme "o" = "u"\nsay "Oh."\n', tmp_path)
    assert made.play is not None
    table = table_of(made.play.visemes)
    assert [(each.shape, each.degree) for each in table.visemes("tʃ")] == [("z", 0.5)]
    assert [each.shape for each in table.visemes("t")] == ["h'"]
    assert [each.shape for each in table.visemes("oː")] == ["u"]


def test_use_brings_visemes(tmp_path: Path) -> None:
    (tmp_path / "mouths.face").write_text('viseme "θ" = "s"\n', "utf-8")
    made = compiled('use "mouths.face"\nsay "a."\n', tmp_path)
    assert made.play is not None and [each.sound for each in made.play.visemes] == ["θ"]
    assert codes('use "mouths.face"\nviseme "θ" = "f"\nsay "a."\n', tmp_path) == ["FS524"]


def test_json_has_them(tmp_path: Path) -> None:
    made = compiled('viseme "θ" = "s" 80%\nviseme "ʙ" = mouth.round 40%\nsay "a."\n', tmp_path)
    assert made.play is not None and load(dump(made.play)).visemes == made.play.visemes


@pytest.mark.parametrize(
    "definition", ['"" = "s"', '"12" = "s"', f'"{"a" * 17}" = "s"', '"θ" = "ꙮ"', '"θ" = smile', '"θ" = mouth.open 2s']
)
def test_what_is_no_viseme(definition: str, tmp_path: Path) -> None:
    found = codes(f'viseme {definition}\nsay "a."\n', tmp_path)
    assert found and found[0] in ("FS523", "FS301", "FS302", "FS303"), found


def test_a_sound_that_nobody_knows_is_told_once(tmp_path: Path) -> None:
    assert codes('say "aꙮa."\nsay "ꙮ and ꙮ."\n', tmp_path) == ["FS525"]
    assert codes('viseme "ꙮ" = "o"\nsay "aꙮa."\n', tmp_path) == []


def test_the_mouth_moves_for_a_sound_that_nobody_knows(tmp_path: Path) -> None:
    made = compiled('say "mꙮm."\n', tmp_path)
    assert made.score is not None
    times = made.score.lines[0].start + np.linspace(0.22, 0.38, 20)
    opened = [perform(made.score).pose(time)["mouth.open"] for time in times[::5]]
    assert max(opened) > 0.05
