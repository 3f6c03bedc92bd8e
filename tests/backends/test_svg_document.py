"""The SVG as a document: names that stay, references that hold, animations that are well formed, colours by name."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from lxml import etree

from facescript.cli.main import main

SVG = "{http://www.w3.org/2000/svg}"
ELEMENTS = set(
    "svg title desc style defs g path rect use image clipPath linearGradient radialGradient stop animate "
    "animateTransform foreignObject circle script".split()
)
SCRIPT = """film 320x240, 700ms long, seed 3
face ada = woman, hair #884422
{more}scene one:
    ada: show smile 60%
    ada: {act}
"""


def built(folder: Path, more: str = "", act: str = "nod", size: str = "") -> etree._Element:
    (folder / "script.face").write_text(SCRIPT.format(more=more, act=act), "utf-8")
    assert main(["build", str(folder / "script.face"), "-o", str(folder / "out.svg"), "--quiet"]) == 0
    return etree.parse(str(folder / "out.svg")).getroot()


@pytest.fixture(scope="module")
def alone(tmp_path_factory: pytest.TempPathFactory) -> etree._Element:
    return built(tmp_path_factory.mktemp("alone"))


@pytest.fixture(scope="module")
def two(tmp_path_factory: pytest.TempPathFactory) -> etree._Element:
    return built(tmp_path_factory.mktemp("two"), more="face bruno = man\n", act='say "Hello, <you>."')


def ids(root: etree._Element, within: str = "") -> dict[str, str]:
    """Every id and its element's name."""
    return {node.get("id"): etree.QName(node).localname for node in root.iter(f"{SVG}*") if node.get("id")}


def test_elements_ids_and_references(two: etree._Element) -> None:
    names = [node.get("id") for node in two.iter(f"{SVG}*") if node.get("id")]
    assert len(names) == len(set(names))
    assert all(re.fullmatch(r"[^\W\d][\w.-]*", name) for name in names)
    assert {etree.QName(node).localname for node in two.iter(f"{SVG}*")} <= ELEMENTS
    text = etree.tostring(two, encoding="unicode")
    assert set(re.findall(r'url\(#([^)]+)\)|href="#([^"]+)"', text))
    for one, other in re.findall(r'url\(#([^)]+)\)|href="#([^"]+)"', text):
        assert (one or other) in names


def test_animations_are_well_formed(two: etree._Element) -> None:
    moving = [node for node in two.iter(f"{SVG}animate", f"{SVG}animateTransform") if node.get("keyTimes")]
    assert len(moving) > 30
    for node in moving:
        times = [float(word) for word in node.get("keyTimes").split(";")]
        assert times == sorted(times)
        assert (times[0], times[-1]) == (0, 1)
        assert len(node.get("values").split(";")) == len(times)
        if node.get("calcMode") == "spline":
            splines = [list(map(float, word.split())) for word in node.get("keySplines").split(";")]
            assert len(splines) == len(times) - 1
            assert all(len(spline) == 4 and 0 <= min(spline) <= max(spline) <= 1 for spline in splines)


def test_every_value_of_an_outline_has_its_commands(two: etree._Element) -> None:
    outlines = [path for path in two.iter(f"{SVG}path") if path.find(f"{SVG}animate[@attributeName='d']") is not None]
    assert len(outlines) > 20
    for path in outlines:
        commands = re.sub(r"[-0-9. ]", "", path.get("d"))
        for value in path.find(f"{SVG}animate[@attributeName='d']").get("values").split(";"):
            assert re.sub(r"[-0-9. ]", "", value) == commands, path.get("id")


def test_ids_stay_when_the_script_changes_elsewhere(alone: etree._Element, two: etree._Element) -> None:
    before, after = ids(alone), ids(two)
    both = set(before) & set(after)
    mine = {name for name in before if name == "ada" or name.startswith("ada-")}
    assert {"ada", "ada-mouth-line", "ada-face-skin", "ada-face-skin-paint", "ada-eye-white-left-clip"} <= both
    assert not [name for name in mine - both if name.endswith(("-paint", "-clip"))]
    assert all(before[name] == after[name] for name in both)
    for name in both:
        if before[name] in ("linearGradient", "radialGradient"):
            one, other = (root.find(f".//{SVG}*[@id='{name}']") for root in (alone, two))
            assert etree.tostring(one) == etree.tostring(other)


def test_title_and_description_are_the_scripts(two: etree._Element) -> None:
    assert two.find(f"{SVG}title").text == "ada and bruno"
    assert two.find(f"{SVG}desc").text == "ada, woman\nbruno, man\nada: Hello, <you>."


def test_colours_have_the_palettes_names(alone: etree._Element) -> None:
    style = alone.find(f"{SVG}style").text
    skin = alone.find(f".//{SVG}radialGradient[@id='ada-face-skin-paint']/{SVG}stop")
    assert re.search(rf"\.{skin.get('class')}{{stop-color:var\(--skin-light,{skin.get('stop-color')}\)}}", style)
    strand = alone.find(f".//{SVG}path[@id='ada-hair-front-strands']")
    assert re.search(rf"\.{strand.get('class')}{{fill:var\(--hair-strand,{strand.get('fill')}\)}}", style)


def test_the_still_picture_is_hidden_where_there_are_no_style_sheets(alone: etree._Element) -> None:
    still = alone.findall(f".//{SVG}g[@class='stood']")
    assert still
    assert all(group.get("display") == "none" for group in still)
    assert not [node for group in still for node in group.iter(f"{SVG}animate", f"{SVG}animateTransform")]


def test_neighbours_share_a_clip(alone: etree._Element) -> None:
    clip = "url(#ada-eye-white-left-clip)"
    groups = [node for node in alone.iter(f"{SVG}*") if node.get("clip-path") == clip]
    assert [etree.QName(group).localname for group in groups] == ["g"]
    names = [path.get("id") for path in groups[0].iter(f"{SVG}path")]
    assert names[0] == "ada-eye-iris-left" and names[-1] == "ada-eye-light-left"


def test_what_stands_behind_is_not_animated_and_is_kept(alone: etree._Element) -> None:
    behind = alone.find(f"{SVG}g[@class='behind']")
    assert behind.get("style") == "will-change:opacity"
    assert [group.get("class") for group in behind] == ["ground", "backdrop"]
    assert behind.find(f".//{SVG}animate") is None
