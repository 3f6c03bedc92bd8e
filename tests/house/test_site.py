"""The site's pages: they have every row of the language's tables, their scripts run, their links lead somewhere."""

from __future__ import annotations

import json
import posixpath
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PIL import Image
from pygments import lexers
from pygments.token import Keyword, Number, String
from website import fences, lexer, links, pictures, site
from website.page import Page, examples
from website.pages import channels, diagnostics
from website.textmate import scopes

from facescript.backends.registry import BACKENDS
from facescript.cli.list import LISTS
from facescript.compile import compile_source
from facescript.diagnostics.catalogue import CATALOGUE
from facescript.diagnostics.model import Severity
from facescript.performance.channels import CHANNELS, MUSCLES
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.kinds.library import kind_names, library_head
from facescript.resolve.units import UNITS
from facescript.resolve.words import BLOCKS, DEFINITIONS, ENDINGS, FACE, FILM, GIVEN, JOINING, KNOBS, MODIFIERS, VERBS
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.voices.registry import ENGINES
from facescript.text import Source
from facescript.world import World

ROOT = Path(__file__).parents[2]
PAGES = {page.uri: page for page in (*site.made(), *site.written())}
SCRIPT = re.compile(r"^```(?:face|face-picture)(?: \{[^}\n]*\})?\n(.*?)^```$", re.MULTILINE | re.DOTALL)
OWN = [page for page in site.made() if not page.home and not page.uri.startswith(("diagnostics", "examples/"))]
"""Pages whose scripts stand nowhere else: those of the others are run by other tests."""


def sited(page: Page) -> str:
    """The page with links as the site has them."""
    return links.coded(links.sited(page.text, page.home, page.uri) if page.home else page.text, page.uri)


# ------------------------------------------------------------------------------------------------ tables


def headings(uri: str) -> set[str]:
    return set(re.findall(r"\{#([\w-]+)\}", PAGES[uri].text))


@pytest.mark.parametrize(
    ("uri", "names"),
    [
        ("reference/blocks.md", {*BLOCKS, *ENDINGS}),
        ("reference/definitions.md", set(DEFINITIONS)),
        ("reference/modifiers.md", set(MODIFIERS)),
        ("reference/muscles.md", set(MUSCLES)),
        (
            "reference/channels.md",
            {channels.base(name) for name in (*PRIMITIVES, *(c.name for c in CHANNELS))} - {*MUSCLES},
        ),
        ("reference/lives.md", {name for name, _ in LISTS["lives"]()}),
        ("reference/actions.md", {form.split(",")[0].split()[0] for form, _ in LISTS["actions"]()} - {*VERBS}),
        ("reference/kinds.md", {name for name, _ in LISTS["faces"]()}),
        ("reference/voices.md", set(ENGINES)),
    ],
)
def test_a_page_has_every_row_of_its_table(uri: str, names: set[str]) -> None:
    assert {name.replace(".", "-").replace(" ", "-") for name in names} - headings(uri) == set()


def test_every_expression_has_its_place() -> None:
    wanted = {name.lower() for name, _ in LISTS["expressions"]()} | {"neutral"}
    assert wanted - headings("reference/expressions.md") - headings("reference/units.md") == set()


def test_every_verb_has_a_page_with_its_modifiers() -> None:
    for verb in VERBS.values():
        text = PAGES[f"reference/statements/{verb.name}.md"].text
        assert verb.form in text
        assert [name for name in verb.modifiers if MODIFIERS[name].form not in text] == []


@pytest.mark.parametrize(
    ("uri", "forms"),
    [
        ("reference/film.md", [row.form for row in FILM.values()]),
        ("reference/face.md", [row.form for row in FACE.values()]),
        ("reference/lives.md", [MODIFIERS[name].form for name in KNOBS]),
        ("reference/outputs.md", [row.suffix for row in BACKENDS]),
        ("reference/values.md", [*UNITS, *GIVEN, *JOINING]),
    ],
)
def test_a_page_names_every_setting(uri: str, forms: list[str]) -> None:
    assert [form for form in forms if f"`{form}`" not in PAGES[uri].text] == []


def test_every_look_is_shown() -> None:
    text = PAGES["reference/kinds.md"].text
    for kind in kind_names():
        head = library_head(kind)
        looks = [f"{name} {choice}" for name, choices in head.looks for choice in choices]
        assert [look for look in looks if f"face x = {kind}, {look}\n" not in text] == []
        assert [tint.name for _, tints in head.tints for tint in tints if tint.name not in text] == []


def test_every_code_has_a_page_with_its_scripts() -> None:
    for entry in CATALOGUE.values():
        text = PAGES[f"diagnostics/{entry.code}.md"].text
        assert f"**{str(entry.severity).capitalize()}.**" in text
        assert (diagnostics.WELL in text) == (entry.stage in ("check", "build")), entry.code
        assert entry.why in text


def test_every_verb_block_and_definition_has_an_example() -> None:
    assert set(examples()) == {*VERBS, *BLOCKS, *ENDINGS, *DEFINITIONS}


# ------------------------------------------------------------------------------------------------ scripts


@pytest.mark.parametrize("page", OWN, ids=lambda page: page.uri)
def test_scripts_run(page: Page) -> None:
    world = World(ROOT / "examples")
    for script in dict.fromkeys(SCRIPT.findall(page.text)):
        found = compile_source(Source("block.face", script), world, EstimatedVoice()).diagnostics
        assert [(item.code, item.message) for item in found if item.severity is not Severity.HINT] == [], script


def test_blocks_ask_for_pictures_that_can_be_had() -> None:
    asked = [picture for page in PAGES.values() for picture in fences.pictures(page.text)]
    assert len({picture.kind for picture in asked}) > 1
    assert [picture.alt for picture in asked if not 0 <= picture.start <= picture.end <= 60] == []


@pytest.mark.parametrize(
    "settings", ['picture="2"', 'picture="2s"', 'film="0s" alt="a" loud="1"', 'picture="2s" plot="2s" alt="a"']
)
def test_settings_that_nobody_can_follow_are_refused(settings: str) -> None:
    with pytest.raises(fences.FenceFault):
        list(fences.pictures(f"```face {{{settings}}}\nnod\n```\n"))


def test_a_block_becomes_a_plain_one_with_its_picture_below() -> None:
    page = '```face {film="0s to 1.5s" alt="It nods."}\nnod\n```\n'
    assert fences.plain(page, lambda asked: f"<{asked.start} {asked.end}>") == "```face\nnod\n```\n\n<0.0 1.5>\n"


def test_pictures_are_drawn_kept_and_thrown_away(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pictures, "KEPT", tmp_path)
    pictures.place.cache_clear()
    still = fences.Picture("picture", "film 64x48\nshow smile", 0.2, 0.2, "A smile.", 32)
    film, plot = replace(still, kind="film", end=0.4), replace(still, kind="plot", end=0.4, wide=400)
    assert pictures.make([still, film, plot]) == 3
    with Image.open(pictures.place(still)) as one, Image.open(pictures.place(film)) as moving:
        assert (one.size, moving.size, moving.n_frames) == ((64, 48), (32, 24), 3)
    assert b"<svg" in pictures.place(plot).read_bytes()
    assert pictures.make([film]) == 0
    assert {path.name for path in tmp_path.iterdir()} == {path.name for path in pictures.files(film)}
    pictures.place.cache_clear()


def test_a_block_that_cannot_be_drawn_is_told(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pictures, "KEPT", tmp_path)
    with pytest.raises(pictures.PictureFault, match="smle"):
        pictures.make([fences.Picture("picture", "show smle\n", 0.0, 0.0, "Nothing.", 32)])
    pictures.place.cache_clear()


def test_few_blocks_are_parts() -> None:
    parts = [page.uri for page in site.written() for _ in re.findall(r"^ *```face-part$", page.text, re.MULTILINE)]
    assert len(parts) <= 12, parts


# ------------------------------------------------------------------------------------------------ links


def anchors(page: Page) -> set[str]:
    """What a link into a page may name."""
    prose = links.BLOCKS.sub("", page.text)
    titles = (title for title in re.findall(r"^#+ (.+)$", prose, re.MULTILINE) if "{#" not in title)
    plain = (re.sub(r"[^\w\s-]", "", title).strip().lower() for title in titles)
    return {re.sub(r"[-\s]+", "-", title) for title in plain} | set(re.findall(r"\{#([\w-]+)\}", prose))


def led(page: Page) -> Iterator[tuple[str, str]]:
    """Where the links of a page lead in the site: place and anchor."""
    for found in links.LINK.finditer(links.BLOCKS.sub("", sited(page))):
        path = (
            posixpath.normpath(posixpath.join(posixpath.dirname(page.uri), found["path"]))
            if found["path"]
            else page.uri
        )
        yield path, (found["anchor"] or "").removeprefix("#")


def test_links_lead_somewhere() -> None:
    known = {uri: anchors(page) for uri, page in PAGES.items()}
    sheets = {f"pictures/sheets/{kind}.png" for kind in kind_names()}
    for page in PAGES.values():
        for path, anchor in led(page):
            there = path in known or path in sheets or (ROOT / "docs" / path).is_file()
            assert there or (ROOT / path).is_file(), f"{page.uri}: {path}"
            assert not anchor or anchor in known[path], f"{page.uri}: {path}#{anchor}"


def test_codes_in_prose_lead_to_their_pages() -> None:
    text = "## FS301\n\nA fault (FS301), `FS302`, [FS303](x.md).\n\n```face-bad\nwait 2  # FS301\n```\n"
    linked = text.replace("(FS301)", "([FS301](../diagnostics/FS301.md))")
    assert links.coded(text, "howto/kiosk.md") == linked


def test_every_page_is_in_the_navigation_once() -> None:
    found = re.findall(r'"([\w/-]+\.md)"', json.dumps(site.nav()))
    assert sorted(found) == sorted(PAGES)


# ------------------------------------------------------------------------------------------------ colours


def test_pages_are_coloured_as_editors_colour() -> None:
    """The golden pages are what VS Code's own library makes of the grammar (`tests/editors/colours.py`)."""
    golden = sorted((ROOT / "tests" / "editors" / "tokens").glob("*.tokens"))
    assert len(golden) > 4
    for path in golden:
        script = path.with_suffix(".face")
        text = (script if script.exists() else ROOT / "examples" / script.name).read_text("utf-8")
        rows: list[str] = []
        for line, stretches in scopes(text):
            rows.append(line)
            words = ((line[start:end].strip(), scope.removesuffix(".face")) for start, end, scope in stretches)
            rows += [f"        {word:20}  {scope}" for word, scope in words if word and scope]
        assert "\n".join(rows).rstrip() + "\n" == _innermost(path.read_text("utf-8")), path.name


def _innermost(golden: str) -> str:
    """A golden page with the last scope of each word alone."""
    return re.sub(r"^(        \S.*?  )(?:[a-z][\w.-]+ )+([a-z][\w.-]+)$", r"\1\2", golden, flags=re.MULTILINE)


def test_pygments_finds_the_lexer() -> None:
    lexer.register()
    found = lexers.get_lexer_by_name("face-bad")
    tokens = [(kind, word) for kind, word in found.get_tokens('say "Hi." # x\nwait 2s\n') if word.strip()]
    assert [kind for kind, word in tokens if word in ("say", '"', "Hi.", "2s", "2")] == [
        Keyword,
        String,
        String,
        String,
        Number,
    ]
