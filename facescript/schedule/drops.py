"""Drops to what they let go: the terms of shows and adds that bear a name, or all of a statement's."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field

from facescript.ir.acts import Add, Drop, Glance, Look, Perform, Scan, Show, in_pass
from facescript.ir.values import Term
from facescript.schedule.deeds import Deed
from facescript.schedule.steps import NEVER

Key = tuple[int, int]
"""A term: its act's order, and its index in the sum."""


@dataclass(slots=True)
class _Worn:
    """What one face wears in one scene: the terms by name, with the number of their `show` (0: an add) and whether they
    are off again; looks by name; and the number of the last `show` without an end, which covers those before it."""

    terms: dict[str, list[tuple[Key, Deed, int]]] = field(default_factory=dict)
    looks: dict[str, list[Deed]] = field(default_factory=dict)
    off: set[Key] = field(default_factory=set)
    shows: int = 0
    base: int = 0


def take_off(deeds: Iterable[tuple[Deed, int]]) -> tuple[dict[int, tuple[Key, ...]], list[Deed]]:
    """The terms that each drop lets go, by its order, and the drops that find nothing. A look or a take that is dropped
    by its statement's name lets go from there on. Each deed comes with its scene."""
    worn: dict[tuple[str | None, int], _Worn] = {}
    found: dict[int, tuple[Key, ...]] = {}
    idle = []
    for deed, scene in sorted(deeds, key=lambda one: (one[0].start, one[0].order)):
        wearing = worn.setdefault((deed.face, scene), _Worn())
        if isinstance(deed.verb, (Show, Add)):
            _put_on(wearing, deed, deed.verb.mix.terms, isinstance(deed.verb, Show))
        elif isinstance(deed.verb, (Look, Glance, Scan, Perform)):
            for name in deed.names:
                wearing.looks.setdefault(name, []).append(deed)
        elif isinstance(deed.verb, Drop):
            name = in_pass(deed.verb.name, deed.step.passes)
            found[deed.order] = _terms(wearing, name, deed.start)
            if not (_looks(wearing, name, deed.start) or found[deed.order]):
                idle.append(deed)
    return found, idle


def _put_on(worn: _Worn, deed: Deed, terms: tuple[Term, ...], base: bool) -> None:
    worn.shows += base
    if base and deed.release == NEVER:
        worn.base = worn.shows
    for index, term in enumerate(terms):
        whole, _, side = term.name.rpartition(".")
        names = {term.name, whole} if side in ("left", "right") else {term.name}
        for name in (*names, *deed.names):
            worn.terms.setdefault(name, []).append(((deed.order, index), deed, worn.shows if base else 0))


def _terms(worn: _Worn, name: str, time: float) -> tuple[Key, ...]:
    """The terms of that name which are on at a time; they are off from then on."""
    keys = tuple(
        key
        for key, wearer, show in worn.terms.pop(name, [])
        if wearer.release > time and key not in worn.off and (show == 0 or show >= worn.base)
    )
    worn.off.update(keys)
    return keys


def _looks(worn: _Worn, name: str, time: float) -> bool:
    """Whether a look of that name is under way at a time; it lets go then."""
    under_way = [deed for deed in worn.looks.pop(name, []) if deed.release > time]
    for deed in under_way:
        deed.release = time
    return bool(under_way)
