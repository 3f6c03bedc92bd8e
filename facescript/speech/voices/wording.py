"""The phones of a text, and those of its words, to when the words are."""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Sequence
from difflib import SequenceMatcher
from itertools import accumulate, pairwise

from facescript.speech.lines import Piece, Word, is_letter, words
from facescript.speech.model import PhoneTime, WordTime


def begun_words(heard: Sequence[PhoneTime], apart: Sequence[Sequence[str]]) -> list[tuple[int, float]]:
    """The words that begin in `heard`, by number, with the second at which they do; always the first.

    `apart` has the symbols of the phones of each word, spoken alone: some differ from those of the text, and some are
    missing there.
    """
    sounding = [phone for phone in heard if phone.symbol]
    owners = [number for number, phones in enumerate(apart) for _ in phones]
    symbols = [symbol for phones in apart for symbol in phones]
    found = SequenceMatcher(None, [phone.symbol for phone in sounding], symbols, autojunk=False).get_matching_blocks()
    places = [(block.a + step, block.b + step) for block in found for step in range(block.size)]
    begun: list[tuple[int, float]] = []
    for (first, low), (last, high) in pairwise([(-1, -1), *places, (len(sounding), len(symbols))]):
        for at in range(max(first, 0), last):
            place = low + (high - low) * (at - first) / (last - first)
            owner = owners[min(max(round(place), 0), len(owners) - 1)] if owners else 0
            if not begun or owner > begun[-1][0]:
                begun.append((owner if begun else 0, sounding[at].start))
    return begun or [(0, 0.0)]


def word_times(piece: Piece, begun: Sequence[tuple[int, float]], heard: Sequence[PhoneTime]) -> tuple[WordTime, ...]:
    """The words of a piece: those that the voice runs together with a word that has `begun` share its time by their
    length."""
    found = words(piece.text)
    total = heard[-1].end
    sounding = [phone for phone in heard if phone.symbol]
    times: list[WordTime] = []
    for (index, start), (following, limit) in zip(begun, [*begun[1:], (len(found), total)], strict=True):
        first, last = (bisect_left(sounding, moment, key=lambda phone: phone.start) for moment in (start, limit))
        end = sounding[last - 1].end if last > first else limit
        times += _shared(piece, found[index:following], start, min(end, limit))
    return tuple(times)


def _shared(piece: Piece, group: tuple[Word, ...], start: float, end: float) -> list[WordTime]:
    texts = [piece.text[word.first : word.last] for word in group]
    counts = list(accumulate((sum(map(is_letter, text)) for text in texts), initial=0))
    moments = [start + (end - start) * count / counts[-1] for count in counts[:-1]] + [end]
    return [
        WordTime(text, piece.first + word.first, piece.first + word.last, *times)
        for text, word, times in zip(texts, group, pairwise(moments), strict=True)
    ]
