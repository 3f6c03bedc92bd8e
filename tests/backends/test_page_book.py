"""The page of a book: chapters to go to, the text in their order, and what stands beside the faces when."""

from __future__ import annotations

from pathlib import Path

import pytest
from lxml import html
from PIL import Image

from facescript.cli.main import main

SCRIPT = """\
film 160x120, 10fps, seed 3, title "Two </script> walks", author "Ada <Stone>"
face ada = woman
    life still
scene one "The <lake>":
    wait 200ms
    picture "lake.png" "A \\"lake\\""
    link "https://example.org/a?b=c&d" "More </p>"
    say "Hello."
    picture none
    say "Bye."
scene two:
    say "Home."
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("page")
    Image.new("RGB", (16, 12), "#88aacc").save(folder / "lake.png")
    (folder / "walks.face").write_text(SCRIPT, "utf-8")
    build = ["build", str(folder / "walks.face"), "--page", "book", "--quiet"]
    assert main([*build, "-o", str(folder / "walks.html")]) == 0
    assert main([*build, "-o", str(folder / "parts.html"), "--split"]) == 0
    return folder


@pytest.fixture(scope="module")
def page(folder: Path) -> html.HtmlElement:
    return html.fromstring((folder / "walks.html").read_text("utf-8"))


def test_head_and_chapters(page: html.HtmlElement) -> None:
    assert page.findtext(".//h1/bdi") == "Two </script> walks"
    assert page.xpath("//p[@class='fb-author']/text()") == ["Ada <Stone>"]
    links = [(link.get("href"), link.findtext("bdi")) for link in page.xpath("//nav//a")]
    assert links == [("#chapter-1", "The <lake>"), ("#chapter-2", "Two")]
    assert [each.get("id") for each in page.xpath("//section")] == ["chapter-1", "chapter-2"]


def test_what_stands_below_each_other(page: html.HtmlElement) -> None:
    order = [child.get("class") for child in page.get_element_by_id("chapter-1")]
    assert order == [None, "fb-picture", "fs-line", "fb-link", "fs-line"]
    picture, link = page.find_class("fb-picture")[0], page.find_class("fb-link")[0]
    assert (picture.find("img").get("alt"), picture.findtext("figcaption")) == ('A "lake"', 'A "lake"')
    assert (link.find("a").get("href"), link.findtext("a/bdi")) == ("https://example.org/a?b=c&d", "More </p>")


def test_a_picture_stands_until_it_is_taken_away_and_a_link_to_the_end(page: html.HtmlElement) -> None:
    chapter, picture, link = (page.find_class(f"fb-{name}")[0] for name in ("chapter", "picture", "link"))
    words = page.find_class("fs-word")
    assert float(picture.get("data-start")) == 0.2
    assert float(words[0].get("data-end")) <= float(picture.get("data-end")) <= float(words[1].get("data-start"))
    assert link.get("data-end") == chapter.get("data-end")


def test_pictures_of_a_page_in_parts_are_files(folder: Path) -> None:
    page = html.fromstring((folder / "parts.html").read_text("utf-8"))
    source = page.find_class("fb-picture")[0].find("img").get("src")
    assert (folder / source).read_bytes() == (folder / "lake.png").read_bytes()
