"""The animated SVG against the W3C's own definition of SVG 1.1: elements, where they stand, attributes, ids."""

from __future__ import annotations

import re
from pathlib import Path
from xml.parsers import expat

import pytest
from lxml import etree
from PIL import Image

from facescript.cli.main import main

DTD = Path("/usr/share/xml/w3c-sgml-lib/schema/dtd/REC-SVG11-20110816/svg11.dtd")
"""From Debian's package w3c-sgml-lib."""

NEWER = re.compile(r' (?:data-[\w-]+|aria-[\w-]+|role|tabindex)="[^"]*"|(?<!<svg) xmlns="http://www.w3.org/2000/svg"')
"""Attributes of SVG 2, and the name space where it is told again, which a DTD does not know."""

AUDIO = re.compile(r"(<foreignObject[^>]*>).*?(?=</foreignObject>)", re.DOTALL)
"""What is no SVG."""

SCRIPTS = {
    "two-people": 'film 640x360, 500ms long, seed 3\nface ada = woman\nface bruno = man\nada: say "Hi, <you> & all."\n',
    "grounds": (
        'film 320x180\nbackground "sky.png"\nface ada = dog\n    life still\nwait 100ms\nbackground none over 100ms\n'
        "background #102040 to #c06040, round over 100ms\nwait 50ms\nview ada 150% over 150ms\n"
    ),
    "gorilla": "film 320x180, 500ms long\nface kong = gorilla\n    life conversation\nshow smile\n",
}


@pytest.fixture(scope="module", params=SCRIPTS)
def document(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> str:
    folder = tmp_path_factory.mktemp("valid")
    Image.new("RGB", (8, 8)).save(folder / "sky.png")
    (folder / "script.face").write_text(SCRIPTS[request.param], "utf-8")
    assert main(["build", str(folder / "script.face"), "-o", str(folder / "out.svg"), "--quiet"]) == 0
    return (folder / "out.svg").read_text("utf-8")


def test_it_is_xml_without_a_definition(document: str) -> None:
    expat.ParserCreate(namespace_separator=" ").Parse(document.encode(), True)
    assert "<!" not in document


@pytest.mark.skipif(not DTD.exists(), reason="no definition of SVG 1.1 here (Debian's w3c-sgml-lib)")
def test_it_is_svg_1_1(document: str) -> None:
    """But for what SVG 2 added: a link without `xlink:`, and attributes for programs that read aloud."""
    text = NEWER.sub("", AUDIO.sub(r"\1", document)).replace(' href="', ' xlink:href="')
    text = text.replace("<svg ", '<svg xmlns:xlink="http://www.w3.org/1999/xlink" ', 1)
    definition = etree.DTD(str(DTD))
    assert definition.validate(etree.fromstring(text.encode())), list(definition.error_log)[:5]
