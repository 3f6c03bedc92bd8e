"""Where a word stands in a line's plain text: the one rule for `on "word":`, `hello."word".2` and spoken words."""

from __future__ import annotations

import re
import unicodedata
from functools import lru_cache

from facescript.ir.acts import Say

_RANGES = (
    "\u0e00-\u0eff\u1000-\u109f\u1780-\u17ff\u3000-\u30ff\u3400-\u9fff\uf900-\ufaff\uff00-\uffef\U00020000-\U0003ffff"
)
_UNSPACED = re.compile(f"[{_RANGES}]")
"""Thai, Lao, Burmese, Khmer, kana, Chinese characters and their signs: written without spaces between words."""

_CHUNK = re.compile(rf"[^\s{_RANGES}]+|[{_RANGES}]+")
"""What stands between spaces; a Latin word or a number among Chinese characters is one of its own."""


def find(text: str, word: str, nth: int = 1) -> tuple[int, int] | None:
    """The stretch of characters of the `nth` (from 1) `word` of `text`; None where there are not so many.

    Words compare without case and without the punctuation around them; several words in a row may be asked for. In
    scripts without spaces a word is any run of characters.
    """
    places = occurrences(text, word)
    return places[nth - 1] if 1 <= nth <= len(places) else None


def occurrences(text: str, word: str) -> tuple[tuple[int, int], ...]:
    """All stretches of `text` that are `word`, in order, not overlapping."""
    if _UNSPACED.search(word):
        return tuple((match.start(), match.end()) for match in re.finditer(re.escape(word.strip()), text))
    wanted = [bare for bare, _, _ in words(word)]
    if not wanted:
        return ()
    found = words(text)
    places, index = [], 0
    while index + len(wanted) <= len(found):
        if all(found[index + step][0] == bare for step, bare in enumerate(wanted)):
            places.append((found[index][1], found[index + len(wanted) - 1][2]))
            index += len(wanted)
        else:
            index += 1
    return tuple(places)


def marked(line: Say, name: str) -> tuple[int, ...]:
    """The marks of a line that are called `name`, by their numbers among its stretches; such a mark is meant rather
    than a word."""
    return tuple(
        number for number, stretch in enumerate(line.stretches) if stretch.kind == "mark" and stretch.value == name
    )


@lru_cache(maxsize=256)
def words(text: str) -> tuple[tuple[str, int, int], ...]:
    """The spaced words of a text: (without case and outer punctuation, first character, one past the last)."""
    found = []
    for match in _CHUNK.finditer(text):
        first, last = match.span()
        while first < last and not _spoken(text[first]):
            first += 1
        while last > first and not _spoken(text[last - 1]):
            last -= 1
        if first < last:
            found.append((unicodedata.normalize("NFC", text[first:last]).casefold(), first, last))
    return tuple(found)


def unspaced(character: str) -> bool:
    """Whether a character belongs to a script written without spaces between words."""
    return bool(_UNSPACED.match(character))


def _spoken(character: str) -> bool:
    return unicodedata.category(character)[0] in "LNM"
