"""Looks of the library's kinds: every choice is drawn whole in any pose, amounts show what they say, tints fit."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from functools import cache

import numpy as np
import pytest

from facescript.ir.kind import Tint
from facescript.performance.performance import REST
from facescript.resolve.kinds.library import kind_names, library_head, library_kind
from facescript.rig.cartoon.face import CartoonRig
from facescript.rig.cartoon.palette import tinted, to_lab
from facescript.rig.cartoon.style import style_of
from rig.outline import anchors
from rig.poses import pose, some, sweep

FAR = [pose(head_yaw=yaw, head_pitch=pitch, head_roll=10) for yaw in (-45, 0, 45) for pitch in (-30, 0, 30)]


@cache
def drawn(
    kind: str, choices: tuple[tuple[str, str], ...] = (), amounts: tuple[tuple[str, float], ...] = ()
) -> CartoonRig:
    """The rig of a kind in some looks."""
    read = library_kind(kind)
    return CartoonRig(style_of(read, dict(read.colours), dict(choices), dict(amounts)))


def ids(rig: CartoonRig) -> set[str]:
    return {shape.id for shape in rig.shapes}


CHOICES = [
    (kind, look, choice) for kind in kind_names() for look, choices in library_head(kind).looks for choice in choices
]
CHOSEN = pytest.mark.parametrize(("kind", "look", "choice"), CHOICES)
HUMAN = pytest.mark.parametrize("kind", ["man", "woman"])


@CHOSEN
def test_a_choice_is_drawn_whole_in_any_pose(kind: str, look: str, choice: str) -> None:
    """Finite, closed, each outline of as many points in all poses, nothing clipped by what is not there."""
    rig = drawn(kind, ((look, choice),))
    picture = rig.draw(np.array([*FAR, *some(6, seed=9)]))
    assert np.isfinite(picture.points).all()
    assert ((picture.opacity >= 0) & (picture.opacity <= 1)).all()
    there = [shape.id for shape in rig.shapes]
    assert len(there) == len(set(there))
    for shape in rig.shapes:
        assert set(shape.clip) <= set(there)
        for contour in shape.contours:
            last = contour.first + contour.count - 1
            assert np.array_equal(picture.points[:, contour.first], picture.points[:, last])


@CHOSEN
def test_a_choice_turns_without_a_jump(kind: str, look: str, choice: str) -> None:
    """A degree of yaw or of pitch moves no point by more than a head that size can."""
    rig = drawn(kind, ((look, choice),))
    for axis, count in (("head.yaw", 91), ("head.pitch", 61)):
        steps = np.abs(np.diff(rig.draw(sweep(axis, count)).points, axis=0)).max()
        assert steps < 8.0, f"{axis}: {steps:.1f} px a degree"


@pytest.mark.parametrize("kind", kind_names())
def test_each_choice_draws_something_of_its_own(kind: str) -> None:
    for look, choices in library_head(kind).looks:
        shown = {choice: drawn(kind, ((look, choice),)) for choice in choices}
        pictures = {
            (tuple(shape.id for shape in rig.shapes), rig.draw(REST[None]).points.tobytes()) for rig in shown.values()
        }
        assert len(pictures) == len(choices), look


@HUMAN
def test_there_are_cuts_and_clothes_enough(kind: str) -> None:
    looks = dict(library_head(kind).looks)
    assert len(looks["hair"]) >= 6 and len(looks["clothes"]) >= 3
    assert "none" in looks["glasses"]


@HUMAN
def test_what_an_amount_of_nothing_hides_is_not_drawn(kind: str) -> None:
    """Freckles that are not there cost nothing."""
    young, old = drawn(kind), drawn(kind, amounts=(("age", 1.0), ("freckles", 1.0)))
    new = ids(old) - ids(young)
    assert {"age-folds-left", "freckles"} <= new
    assert "brow-furrow" in ids(young), "a muscle shows it"
    shown = dict(zip((shape.id for shape in old.shapes), old.draw(REST[None]).opacity[0], strict=True))
    assert all(shown[name] > 0.3 for name in new)


@HUMAN
def test_age_furrows_each_side_and_the_forehead(kind: str) -> None:
    def lines(age: float) -> Mapping[str, float]:
        rig = drawn(kind, amounts=(("age", age),))
        return dict(zip((shape.id for shape in rig.shapes), rig.draw(REST[None]).opacity[0].tolist(), strict=True))

    young, old = lines(0.0), lines(1.0)
    for name in ("forehead-lines", "eye-crows-left", "eye-crows-right", "eye-pouch-left"):
        assert young[name] == 0.0 and old[name] > 0.2, name


@HUMAN
def test_width_moves_both_sides_alike_and_ears_with_the_face(kind: str) -> None:
    half: dict[tuple[str, float], float] = {}
    for width in (0.0, 0.5, 1.0):
        rig = drawn(kind, amounts=(("width", width),))
        picture = rig.draw(REST[None])
        for name in ("face-skin", "ear-left", "ear-right"):
            x = anchors(rig, picture, name)[0, :, 0] - rig.eyes[0]
            half[name, width] = float(np.abs(x).max())
        x = anchors(rig, picture, "face-skin")[0, :, 0] - rig.eyes[0]
        assert x.max() == pytest.approx(-x.min())
    for name in ("face-skin", "ear-left", "ear-right"):
        assert half[name, 0.0] < half[name, 0.5] - 8 < half[name, 1.0] - 16, name


def test_a_temple_of_glasses_shows_on_the_side_that_is_turned_to_us() -> None:
    rig = drawn("woman", (("glasses", "round"),))
    slots = [[shape.id for shape in rig.shapes].index(f"glasses-temple-{side}") for side in ("left", "right")]
    for yaw, wanted in ((0, (0, 0)), (-30, (1, 0)), (30, (0, 1))):
        assert rig.draw(pose(head_yaw=yaw)[None]).opacity[0, slots].tolist() == list(wanted)


@pytest.mark.parametrize("choice", ["moustache", "full"])
def test_a_beard_goes_down_with_the_jaw(choice: str) -> None:
    rig = drawn("man", (("beard", choice),))
    shut, open_ = (rig.draw(each[None]) for each in (REST, pose(mouth_jaw=1.0, mouth_open=0.8)))
    chin = {"moustache": "face-skin", "full": "beard-back"}[choice]
    low = [anchors(rig, picture, chin)[0, :, 1].max() for picture in (shut, open_)]
    assert low[1] > low[0] + 10
    lip = [anchors(rig, picture, "beard-moustache")[0, :, 1].mean() for picture in (shut, open_)]
    assert abs(lip[1] - lip[0]) < 12


@pytest.mark.parametrize("choice", ["thin", "bold"])
@HUMAN
def test_brows_of_any_breadth_move_alike(kind: str, choice: str) -> None:
    moved = []
    for look in ("usual", choice):
        rig = drawn(kind, (("eyebrows", look),))
        rest, up = (anchors(rig, rig.draw(each[None]), "brow-body-left")[0] for each in (REST, pose(brow_inner=1.0)))
        moved.append(up - rest)
    assert np.allclose(moved[0], moved[1])


# ---------------------------------------------------------------------------------------------------- colours


def tints() -> Iterator[tuple[str, str, Tint]]:
    """Kinds, families and the colours that have a name; an animal's hair is its fur."""
    for kind in kind_names():
        head = library_head(kind)
        for look, found in head.tints:
            yield from ((kind, look if look in head.families else "fur", tint) for tint in found)


@pytest.mark.parametrize(("kind", "family", "tint"), list(tints()), ids=lambda value: getattr(value, "name", value))
def test_a_tint_keeps_its_family_in_order(kind: str, family: str, tint: Tint) -> None:
    """Lights above the base, shadows below, all of them colours."""
    drawn_in = dict(library_kind(kind).colours)
    new = tinted(drawn_in, {family: tint.colour})
    base = to_lab(drawn_in[f"{family}.base"])[0]
    for name, colour in drawn_in.items():
        if name.startswith(f"{family}."):
            assert re.fullmatch("#[0-9a-f]{6}", new[name])
            above = to_lab(colour)[0] - base
            assert np.sign(above) * (to_lab(new[name])[0] - to_lab(new[f"{family}.base"])[0]) > -0.01, name


@HUMAN
def test_skins_that_colours_go_with_are_skins(kind: str) -> None:
    found = dict(library_head(kind).tints)
    skins = {tint.name for tint in found["skin"]}
    assert len(skins) >= 8
    for tints_of in found.values():
        assert {skin for tint in tints_of for skin in tint.goes} <= skins
    for skin in skins:
        for family in ("hair", "eyes", "lips"):
            assert sum(not tint.goes or skin in tint.goes for tint in found[family]) >= 2, (skin, family)


def chroma(colour: str) -> float:
    return float(np.hypot(*to_lab(colour)[1:]))


def test_pale_skin_has_shadows_of_flesh_and_grey_hair_has_grey_ones() -> None:
    colours = dict(library_kind("woman").colours)
    pale = tinted(colours, {"skin": "#f9dac6"})
    assert chroma(pale["skin.shade"]) > chroma("#f9dac6") + 0.01
    grey = tinted(colours, {"hair": "#8b8a8c"})
    assert all(chroma(grey[name]) < 0.02 for name in grey if name.startswith("hair."))


def test_a_beard_follows_the_hair_unless_it_has_a_colour() -> None:
    colours = dict(library_kind("man").colours)
    assert to_lab(tinted(colours, {"hair": "#e3d2ae"})["beard.base"])[0] > 0.7
    assert tinted(colours, {"hair": "#e3d2ae", "beard": "#202020"})["beard.base"] == "#202020"
