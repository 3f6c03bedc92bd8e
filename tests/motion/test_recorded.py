"""Recorded faces that are played: what was built comes back, and the blending law holds for them."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scripted import Letters

from facescript.cli.main import main
from facescript.compile import compile_source
from facescript.live.model import Happening
from facescript.live.run.run import Run
from facescript.motion.perform import perform
from facescript.owners.account import Accounts
from facescript.performance.channels import NAMES
from facescript.schedule.score import Score
from facescript.shapes import arkit, fap
from facescript.text import Source
from facescript.world import World

HEAD = "film 640x360, 60fps\nface ada = woman\n    life {life}\n"

MADE = """film 640x360, 60fps, seed 3
face ada = woman
    life calm
together:
    say "We may show her off."
    look left 15deg
show happiness
look at camera, head 60%
show anger 80% + head.roll 6deg
blink
show AU2.left + AU20 50%
nod
"""

TOLERANCE = {
    "arkit": dict.fromkeys(("deg", "1"), 0.02),
    "fap": {"deg": 0.02, "1": 0.1},
    "channels": dict.fromkeys(("deg", "1"), 1e-3),
}
"""By how much a channel that a kind of file has may differ at most once it is played, by its unit. Parameters of MPEG-4
are whole numbers."""

LOST = {
    "arkit": ("brow.inner", "lip.pucker", "chin", "mouth.wide", "mouth.lower", "mouth.teeth", "mouth.tongue"),
    "fap": ("chin", "mouth.upper", "mouth.lower", "mouth.teeth"),
    "channels": (),
}
"""What comes back otherwise, as `docs/live.md` has it: sides that are one shape, what the gap and the jaw tell."""


def scored(folder: Path, lines: str, life: str = "still") -> Score:
    compiled = compile_source(Source("s.face", HEAD.format(life=life) + lines), World(folder), Letters())
    assert compiled.score is not None, [item.message for item in compiled.diagnostics]
    return compiled.score


def channel(score: Score, name: str, times: list[float]) -> list[float]:
    performance = perform(score)
    return [round(performance.pose(time)[name], 4) for time in times]


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Takes: of a script in each kind of file; of a head that turns; of a smile with a head; of a smile alone."""
    made = tmp_path_factory.mktemp("takes")
    (made / "made.face").write_text(MADE, "utf-8")
    outputs = [word for suffix in ("csv", "arkit.csv", "fap") for word in ("-o", str(made / f"made.{suffix}"))]
    assert main(["build", str(made / "made.face"), *outputs, "--quiet"]) == 0
    (made / "turn.csv").write_text("time,head.yaw\n" + "".join(f"{t / 10},{t}\n" for t in range(21)))
    smile = "".join(f"{t / 10},0.6,0.2,10,-8,-8\n" for t in range(21))
    header = "time,cheek.lower.left,cheek.lower.right,head.yaw,eye.left.yaw,eye.right.yaw\n"
    (made / "smile.csv").write_text(header + smile)
    (made / "lids.csv").write_text("time,lid.left,lid.right\n" + "".join(f"{t / 10},0.3,0.3\n" for t in range(101)))
    return made


def rows_of(path: Path) -> NDArray[np.float64]:
    with path.open(encoding="utf-8") as file:
        return np.array([[float(row[name]) for name in NAMES] for row in csv.DictReader(file)])


@pytest.mark.parametrize(("kind", "name"), [("arkit", "made.arkit.csv"), ("fap", "made.fap"), ("channels", "made.csv")])
def test_what_was_built_comes_back(kind: str, name: str, folder: Path) -> None:
    built = rows_of(folder / "made.csv")
    score = scored(folder, f'play "{name}"\n')
    act = next(act for act in score.acts if act.face)
    assert act.settled == pytest.approx(len(built) / 60, abs=1e-4)
    times = np.arange(len(built)) / 60
    drawn = perform(score).sample_face("ada", times)[:, : len(NAMES)]
    whole = slice(13, len(built) - 1)
    off = dict(zip(NAMES, np.abs(drawn - built)[whole].max(axis=0), strict=True))
    has = {"arkit": arkit.channels(), "fap": fap.channels(), "channels": NAMES}[kind]
    told = [name for name in has if name in off and not name.startswith(LOST[kind] or ("-",))]
    assert len(told) > 30
    for channel_name in told:
        unit = "deg" if channel_name.endswith(("yaw", "pitch", "roll")) else "1"
        assert off[channel_name] <= TOLERANCE[kind][unit], channel_name


def test_it_settles_at_its_end_and_comes_and_goes_over_200_ms(folder: Path) -> None:
    score = scored(folder, 'play "smile.csv" as take\nnod\n')
    assert [act.start for act in score.acts if act.face] == [0.0, pytest.approx(2.1)]
    smile = channel(score, "cheek.lower.left", [0.0, 0.1, 0.2, 1.0, 2.1, 2.2, 2.3])
    assert smile == pytest.approx([0.0, 0.3, 0.6, 0.6, 0.6, 0.3, 0.0])
    assert [marker.name for marker in score.markers] == ["take"]


def test_speed_and_for(folder: Path) -> None:
    score = scored(folder, 'play "turn.csv" for 1s, speed 50%\n')
    assert next(act.settled for act in score.acts if act.face) == pytest.approx(1.0)
    assert channel(score, "head.yaw", [0.5, 0.9]) == pytest.approx([2.5, 4.5])
    assert next(act.settled for act in scored(folder, 'play "turn.csv", speed 200%\n').acts if act.face) == 1.05


def test_a_later_show_covers_it_and_an_older_one_comes_back(folder: Path) -> None:
    lines = 'show AU12 20% + AU4 50% over 0ms\nplay "smile.csv"\nat 1s: show AU12 90% over 0ms for 500ms back in 0ms\n'
    score = scored(folder, lines)
    assert channel(score, "cheek.lower.left", [0.5, 1.2, 1.7, 2.4]) == [0.6, 0.8924, 0.6, 0.2]
    assert channel(score, "brow.lower.left", [0.5, 1.2]) == [0.5, 0.0], "the take has no brow; the later show has"


def test_what_is_added_adds(folder: Path) -> None:
    score = scored(folder, 'play "smile.csv"\nat 500ms: add AU12 10% + AU1 40% over 0ms\n')
    assert channel(score, "cheek.lower.right", [1.0]) == [0.3]
    assert channel(score, "brow.inner.left", [1.0]) == [0.4]


def test_head_and_eyes_are_the_takes_until_a_later_look(folder: Path) -> None:
    lines = 'look left 20deg, head 0%\nplay "smile.csv"\nat 1.2s: look right 10deg, eyes only for 400ms\n'
    score = scored(folder, lines)
    start = next(act.start for act in score.acts if act.face and act.label is None and act.settled - act.start > 2)
    times = [start + 0.5, 1.5, start + 2.0]
    assert channel(score, "head.yaw", times) == pytest.approx([10.0] * 3, abs=1e-3)
    eye = channel(score, "eye.left.yaw", times)
    assert eye[0] == pytest.approx(-8.0, abs=1e-3) and eye[2] == pytest.approx(-8.0, abs=1e-3)
    assert eye[1] < -18.0, "in the head, which the take has turned by 10 degrees the other way"


def test_a_take_without_eyes_leaves_them_on_their_target(folder: Path) -> None:
    score = scored(folder, 'look at camera\nplay "turn.csv"\n')
    assert channel(score, "gaze.yaw", [1.0, 1.9]) == pytest.approx([0.0, 0.0], abs=0.05)
    assert channel(score, "head.yaw", [1.8])[0] > 10.0


def test_life_waits_on_what_a_take_has(folder: Path) -> None:
    """Ten seconds without a blink of its own; the head, of which the take tells nothing, lives on."""
    score = scored(folder, 'play "lids.csv"\n', life="conversation")
    drawn = perform(score).sample_face("ada", np.linspace(0.3, 9.9, 600))
    assert np.ptp(drawn[:, NAMES.index("lid.left")]) < 0.2 < drawn[:, NAMES.index("lid.left")].min() + 0.2
    assert np.ptp(drawn[:, NAMES.index("head.yaw")]) > 0.5


def test_a_drop_by_its_name_ends_it(folder: Path) -> None:
    score = scored(folder, 'play "smile.csv" as take\nat 1s: drop take\n')
    assert channel(score, "cheek.lower.left", [0.9, 1.1, 1.3]) == pytest.approx([0.6, 0.3, 0.0])


def test_it_is_told_who_owned_a_channel(folder: Path) -> None:
    score = scored(folder, 'play "smile.csv"\n')
    accounts = Accounts(score, score.faces[0])
    for name in ("cheek.lower.left", "head.yaw", "eye.left.yaw", "head.roll"):
        account = accounts.at(name, 1.0)
        assert account.value == pytest.approx(perform(score).pose(1.0)[name])
        assert name == "head.roll" or (account.owner and account.owner.what == 'play "smile.csv"')
    assert accounts.at("mouth.open", 1.0).owner is None


def test_a_run_plays_as_a_build_does_and_goes_on_over_an_event(folder: Path) -> None:
    """The eyes that a take has are not let go where the rest of the play is planned anew."""
    lines = 'play "smile.csv"\nwait 1s\nwhen signal "x":\n    add AU1 50%\n'
    text = HEAD.format(life="still") + lines
    built = perform(scored(folder, lines)).sample_face("ada", np.arange(60) / 60)[:, : len(NAMES)]
    compiled = compile_source(Source("s.face", text), World(folder), Letters())
    assert compiled.play is not None
    run = Run(compiled.play, Letters(), 60.0)
    early = [run.frame(number).values for number in range(30)]
    run.hear(Happening("signal", 0.5, "x"))
    late = [run.frame(number).values for number in range(30, 60)]
    eye = NAMES.index("eye.left.yaw")
    assert np.array(early + late)[:, eye] == pytest.approx(built[:, eye])
    assert late[-1][NAMES.index("brow.inner.left")] == pytest.approx(0.5)
