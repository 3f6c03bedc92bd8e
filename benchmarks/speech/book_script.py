"""Minutes to a book's script of about that length: chapters of varied sentences, with looks, pictures and links."""

from __future__ import annotations

import random
from collections.abc import Iterator

WORDS = 228
"""Words a minute, pauses counted in."""

CHAPTER = 10
"""Minutes of a chapter."""

HEAD = """\
film 1280x720, 25fps, seed 21, title "The valley", author "A. Writer"
face ada = woman, voice en-us female
    life reading
"""

WHO = (
    "the old miller, a girl with a lantern, the keeper of the bridge, my grandmother, the youngest fisherman, "
    "a tired postman, the boat builder, somebody from the next valley, the teacher, a stranger in a grey coat"
).split(", ")
DID = (
    "walked past, remembered, waited for, drew a map of, told a story about, looked for, listened to, "
    "could not forget, painted, carried a letter to"
).split(", ")
WHAT = (
    "the harbour, the white tower, the river below the mill, a garden without a gate, the last train, the island, "
    "the market, the empty theatre, the lighthouse, the road over the hills"
).split(", ")
WHEN = (
    "before the rain began, in the early morning, while the bells were ringing, without a word, "
    "as if nothing had happened, until the lamps were lit, for the third time that winter, "
    "because the wind had turned, although it was already late, and smiled"
).split(", ")
BETWEEN = ("wait 400ms", "wait 700ms", "nod 30%", "look left 10deg for 1s", "show smile 20%")


def book_script(minutes: float, seed: int = 5) -> str:
    """The script; its picture is `lake.png`."""
    chance = random.Random(seed)
    chapters = max(1, round(minutes / CHAPTER))
    return "\n".join([HEAD, *(_chapter(number, minutes / chapters, chance) for number in range(1, chapters + 1))])


def _chapter(number: int, minutes: float, chance: random.Random) -> str:
    lines = [f'scene chapter{number} "Chapter {number}":', '    picture "lake.png" "The lake"']
    left = minutes * WORDS
    while left > 0:
        text = " | ".join(_sentences(chance))
        left -= len(text.split())
        lines += [f'    say "{text}"', f"    {chance.choice(BETWEEN)}"]
    return "\n".join([*lines, f'    link "https://example.org/{number}" "More about chapter {number}"', ""])


def _sentences(chance: random.Random) -> Iterator[str]:
    for _ in range(chance.randint(2, 4)):
        text = " ".join(chance.choice(part) for part in (WHO, DID, WHAT, WHEN))
        yield f"{text[0].upper()}{text[1:]}.".replace("smiled", "[smile 40%]smiled[/]")
