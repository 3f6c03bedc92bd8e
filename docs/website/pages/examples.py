"""The scripts in `examples/` to a page each with its moment of the gallery, and an index of them."""

from __future__ import annotations

from collections.abc import Iterator

import make_pictures

from website.page import Page, block

SHARED = "studio"
"""The script that others use; nothing is played in it."""


def pages() -> Iterator[Page]:
    rows = [f"- [{name}]({name}.md): {make_pictures.told(name)}" for name in (*make_pictures.GALLERY, SHARED)]
    yield Page("examples/index.md", "All examples", HEAD + "\n".join(rows) + "\n")
    for name, time in make_pictures.GALLERY.items():
        yield Page(
            f"examples/{name}.md", name, _text(name, f"![{name}.face at {time:g} s](../pictures/gallery-{name}.png)\n")
        )
    yield Page(f"examples/{SHARED}.md", SHARED, _text(SHARED, ""))


HEAD = """\
# Examples

The scripts in the folder `examples/`. `facescript build examples/hello.face -o hello.mp4` makes the whole film, and
with `-o hello.svg` a picture that moves, for a browser. The [gallery](../gallery.md) has a moment of each.

"""


def script(name: str) -> str:
    return (make_pictures.EXAMPLES / f"{name}.face").read_text("utf-8")


def _text(name: str, picture: str) -> str:
    return "\n".join([f"# {name}.face\n", f"{make_pictures.told(name)}\n", picture, block(script(name))])
