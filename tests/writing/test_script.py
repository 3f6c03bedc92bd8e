"""Plays to scripts: what compiles to a play is written as a script that compiles to the same play."""

from __future__ import annotations

from pathlib import Path

import pytest

from facescript.diagnostics.model import Diagnostics, Severity
from facescript.ir.play import Play
from facescript.ir.values import Draw
from facescript.resolve.resolver import resolve
from facescript.resolve.units import ANGLE, LENGTH, RATE, SHARE, TIME
from facescript.syntax.formatter import format_source
from facescript.syntax.parser import parse
from facescript.text import Source
from facescript.world import World
from facescript.writing.amounts import amount
from facescript.writing.same import difference
from facescript.writing.script import Written, write

ROOT = Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples").glob("*.face"))
SCRIPTS = ROOT / "tests" / "resolve" / "scripts"
RUNNING = [
    path for path in sorted(SCRIPTS.glob("*.face")) if "refused" not in path.with_suffix(".txt").read_text("utf-8")
]

MANY = {
    "crossing scopes": """
        face ada = woman
        face bruno = man
        action bow(then, sum):
            at then: ada: nod as bowed
            at bowed.end + (1s to 2s): ada: drop sum over 300ms
        scene one:
            ada: add smile 40% as warm
            ada: say "I have a cup and a cup." as hello
                on "cup".2: bruno: look at ada.mouth
            bow hello."cup".2.end + 100ms, sum warm as done
            repeat 2 times:
                repeat for 3s:
                    ada: blink as again
                    at again.end: bruno: shake 20% to 40% for 400ms
            wait until done.end - 20ms
        scene two "At night" with bruno:
            view bruno 180% over 1s
            bruno: wink left as closed
    """,
    "persons": """
        target ann moves
            lost
            1s -80cm 0cm 2m
            lost
            4s 80cm 0cm 2m
            lost
        action greet(who):
            glance who, head only, speed 80%
            look left 20deg down 5deg over 2s, latency 100ms
        look at camera
        when person arrives as guest:
            greet guest
            stop
        when heard "no":
            restart
        event ann arrives at 2s
        event heard "No!" at 1s to 3s
    """,
    "sums": """
        expression crooked(lift = 40%) = smile.left + AU7 lift - head.roll 3deg
        expression smile = AU12 80%
        expression nodding = head.pitch -12deg
        show crooked(lift = 60%) 80% - crooked 10% + smile.right 30%
        add (smile 40% + head.yaw 8deg) 50% for 2s back in 1s ease out, spontaneous
        add head.pitch 2deg to 5deg, posed
        nod 30%
        tilt right 40%
        drop crooked
        drop smile.right ease linear
    """,
    "texts": r"""
        face mei = woman, voice cmn female, rate 90%
        say "小明在长城[read zhang3]长[/]大。 再见 \[bye\] | now [wait 300ms]then [mark here]*on*", volume 50%
    """,
    "brackets": """
        target cup at 10cm -12cm 20cm
        action bow:
            nod as bowed
        say "[smile 40%]One [look at cup]two[/] three [nod 20% for 300ms]four [bow] five."
            "[add blink 50%]Six[/] [blink]seven, eight and nine, ten and eleven, and so on to the end of all."
            "Fourteen."
    """,
    "grounds": """
        film 640x480, 25fps, seed 9, 40s long, screen 45%, 35cm wide, title "A \\"title\\" [x]", author "Me"
        life mine = conversation, blink 8/min
        face ada = woman, seed 12
            hair #112233 still
            life mine, sway 20%
            gaze eye-mover
            at 10% -5%
            size 80%
        viseme "ʙ" = mouth.round 60% + mouth.upper 10%
        viseme "θ" = "s" 80%
        target far of (10% 5%) (1cm 2cm 3m)
        background #a08060 to #c0a080 to #ffffff, towards 45deg over 1s
        background none
        link "https://example.org/?a=b" "More"
        life calm over 1s, nods 10% to 20%
        scan far, 400ms to 1s each, at random, head 40%
        wait 100ms / 3
        repeat forever:
            choose:
                look away
                in turn:
                    glance far.nearest for 1s / 7
                    wait 2s to 3s
    """,
}


def compiled(text: str, folder: Path = ROOT / "examples", name: str = "script.face") -> Play:
    diagnostics = Diagnostics()
    play = resolve(parse(Source(name, text), diagnostics), World(folder), diagnostics)
    assert [item.message for item in diagnostics if item.severity is Severity.ERROR] == []
    assert play is not None
    return play


def checked(play: Play, folder: Path) -> Written:
    """The script of a play, once it has been seen to compile to the same play."""
    written = write(play, World(folder), "again.face")
    again = compiled(written.text, folder, "again.face")
    assert difference(play, again, {old: new for old, (new, _) in written.renamed.items()}) is None
    return written


def unindented(text: str) -> str:
    return "\n".join(line[8:] for line in text.strip("\n").split("\n")) + "\n"


@pytest.mark.parametrize("path", [*EXAMPLES, *RUNNING], ids=lambda path: path.stem)
def test_a_script_of_a_script_is_the_same_play(path: Path) -> None:
    checked(compiled(path.read_text("utf-8"), path.parent, path.name), path.parent)


@pytest.mark.parametrize("text", MANY.values(), ids=MANY)
def test_all_that_a_play_holds_is_written(text: str) -> None:
    written = checked(compiled(unindented(text)), ROOT / "examples")
    layout = format_source(Source("again.face", written.text))
    assert format_source(Source("again.face", layout)) == layout


def test_a_script_reads_as_one_that_was_written() -> None:
    text = 'face ada = woman, voice en-us female\n\nshow smile 60% - AU6 20% over 400ms\nsay "Hello *there*."\n'
    play = compiled("face ada = woman, voice en-us female\n" + text.partition("\n\n")[2])
    assert format_source(Source("x", write(play, World(ROOT), "x.face").text)) == text


def test_paths_are_those_of_the_scripts_folder(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "take.wav").write_bytes(b"")
    play = compiled('say from "take.wav"\n', tmp_path)
    assert 'from "../take.wav"' in write(play, World(tmp_path), "in/x.face").text


@pytest.mark.parametrize(
    ("value", "kind", "text"),
    [
        (0.3, TIME, "300ms"),
        (0.0, TIME, "0s"),
        (1.5, TIME, "1.5s"),
        (0.6, SHARE, "60%"),
        (-12.0, LENGTH, "-12cm"),
        (1 / 3, TIME, "(1s / 3)"),
        (Draw(5.0, 7.25), ANGLE, "5deg to 7.25deg"),
        (18.77, RATE, "18.77/min"),
    ],
)
def test_amounts_are_written_shortest(value: float | Draw, kind: str, text: str) -> None:
    assert amount(value, kind) == text


def test_any_number_is_read_again_as_it_is() -> None:
    for value in (0.1 + 0.2, 0.7999999999999999, 2 / 3, 1e-7, 12345.6789):
        play = compiled(f"wait {amount(value, TIME)}\n")
        (wait,) = play.scenes[0].body.items
        assert wait.verb.duration == value  # type: ignore[union-attr]
