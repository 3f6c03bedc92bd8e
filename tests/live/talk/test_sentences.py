"""A text that comes in pieces is said sentence by sentence, however it is cut."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st

from facescript.live.talk.sentences import LONGEST, Sentences

TEXT = "Hello there! I am Dr. Who. It costs 3.50 today... Yes?\nA line\n\n“Really?” she asked. 你好。再见。The rest"
SENTENCES = [
    "Hello there!",
    "I am Dr. Who.",
    "It costs 3.50 today...",
    "Yes?",
    "A line",
    "“Really?”",
    "she asked.",
    "你好。",
    "再见。",
    "The rest",
]


def cut(text: str, places: list[int]) -> list[str]:
    edges = [0, *sorted(place % (len(text) + 1) for place in places), len(text)]
    return [text[first:last] for first, last in pairwise(edges)]


@settings(max_examples=40, deadline=None)
@given(st.lists(st.integers(0, 1000), max_size=12))
def test_the_sentences_do_not_hang_on_the_pieces(places: list[int]) -> None:
    sentences = Sentences()
    found = [one for piece in cut(TEXT, places) for one in sentences.take(piece)]
    assert [*found, *sentences.rest()] == SENTENCES


def test_a_sentence_is_there_as_soon_as_it_is_complete() -> None:
    sentences = Sentences()
    assert list(sentences.take("One. Two")) == ["One."]
    assert list(sentences.take(" and more.")) == []
    assert list(sentences.take(" ")) == ["Two and more."]


def test_a_text_without_ends_is_cut_between_words() -> None:
    sentences = Sentences()
    found = [*sentences.take("word " * 200), *sentences.rest()]
    assert all(len(one) <= LONGEST for one in found) and " ".join(found).split() == ["word"] * 200


def test_what_has_nothing_to_say_is_left_out() -> None:
    sentences = Sentences()
    assert [*sentences.take("... \n --- \n Yes. "), *sentences.rest()] == ["Yes."]
