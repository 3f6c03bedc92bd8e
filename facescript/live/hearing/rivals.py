"""Words to those that sound nearly like them: what was said may be one of these, and then it was not the word."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path

Sounds = tuple[str, ...]
"""How a word is said: names of sounds (ARPAbet)."""

Dictionary = Mapping[str, Sequence[Sounds]]

COMMON = """
a about all and are at be because but by can come could day did do does down for get give go good great have he hello
help her here hi him his how i in is it just know like little look man many me more much my new nice not now of oh okay
on one open or other our out over people please right say see she so some sorry stop take tell that the their them then
there they thing think this time to two up us very wait want was we well were what when where which who why will with
would yeah yes you your
""".split()
"""What people say often: it competes as a word alone."""


def read_dictionary(path: Path) -> dict[str, list[Sounds]]:
    """A dictionary of the CMU's form: a word (a second way to say it is `word(2)`) and its sounds, a line each."""
    found: dict[str, list[Sounds]] = {}
    for line in path.read_text("utf-8").splitlines():
        word, *sounds = line.split()
        found.setdefault(word.split("(")[0], []).append(tuple(sounds))
    return found


class Rivals:
    """The words of a dictionary by how they begin and end: two that differ in one sound do one of both alike."""

    def __init__(self, dictionary: Dictionary, often: Callable[[str], float]) -> None:
        self._often = often
        self._first: dict[str, list[tuple[str, Sounds]]] = {}
        self._last: dict[str, list[tuple[str, Sounds]]] = {}
        for word, ways in dictionary.items():
            for sounds in ways if word.isalpha() else ():
                self._first.setdefault(sounds[0], []).append((word, sounds))
                self._last.setdefault(sounds[-1], []).append((word, sounds))

    def of(self, ways: Iterable[Sounds], most: int) -> list[str]:
        """The words that differ in one sound from a word that is said in these ways, frequent ones first."""
        mine = frozenset(ways)
        near = {
            word: None
            for one in mine
            for word, other in (*self._first.get(one[0], ()), *self._last.get(one[-1], ()))
            if _near(one, other) and other not in mine
        }
        return sorted(near, key=lambda word: -self._often(word))[:most]


def _near(one: Sounds, other: Sounds) -> bool:
    """Whether two words differ in one sound: in another one there, one more or one less."""
    if abs(len(one) - len(other)) > 1:
        return False
    same = min(len(one), len(other))
    first = next((at for at in range(same) if one[at] != other[at]), same)
    last = next((at for at in range(same - first) if one[-1 - at] != other[-1 - at]), same - first)
    return max(len(one), len(other)) - first - last <= 1
