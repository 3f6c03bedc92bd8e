"""The settings of film, faces and scenes to a page each."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from facescript.resolve.words import DEFINITIONS, FACE, FILM, KNOBS, VOICE, Modifier
from website.page import Page, anchor, block, examples, sentence, table


def pages() -> Iterator[Page]:
    yield Page("reference/film.md", "Film", _page("film", FILM_HEAD, FILM.values()))
    yield Page("reference/face.md", "Face", _page("face", FACE_HEAD, FACE.values()))


FILM_HEAD = """\
What the outputs are like, once for a script; in one line or several, each thing once. The command line may say
otherwise (`--size`, `--fps`, `--seed`).
"""

FACE_HEAD = """\
Behind its [kind](kinds.md), on its line after commas or on lines below it. Looks that are not said are the kind's
usual ones, or drawn by `seed`. Without any `face` a script has one, a woman whose name is `somebody`.
"""


def _page(name: str, head: str, rows: Iterable[Modifier]) -> str:
    row = DEFINITIONS[name]
    listed = ((f"`{each.form}`", sentence(each.help), _more(each)) for each in rows)
    return "\n".join(
        [
            f"# {name}\n",
            block(row.form, "face-part"),
            head,
            examples()[name],
            "## Settings\n",
            table(("written", "is", "more"), listed),
        ]
    )


def _more(row: Modifier) -> str:
    """Where a setting is told at length."""
    if row.name == "voice":
        return "[voices](voices.md)"
    if row.name in VOICE:
        return f"[{row.name}](modifiers.md#{anchor(row.name)})"
    if row.name == "life" or row.name in KNOBS:
        return "[lives](lives.md)"
    if row.name == "screen":
        return "[the flat screen](../language.md#6-the-flat-screen)"
    return (
        "[kinds and looks](kinds.md)"
        if row.takes == "look" or row.name in ("age", "width", "make-up", "freckles")
        else ""
    )
