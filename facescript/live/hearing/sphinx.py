"""An utterance to which of some English phrases it is, and how sure that is, by PocketSphinx.

Three searches hear it: one that knows the phrases alone, one that knows them with words that sound nearly like theirs,
and one that knows only sounds. It is a phrase as far as the first explains it as well as the others do.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from math import exp, log
from pathlib import Path
from typing import Any

from pocketsphinx import Config, Decoder, LogMath, NGramModel, get_model_path

from facescript.live.hearing.activity import HOP, Samples
from facescript.live.hearing.ear import BEFORE, BEHIND
from facescript.live.hearing.phrases import Phrase
from facescript.live.hearing.rivals import COMMON, Rivals, Sounds, read_dictionary

WIDE: Mapping[str, Any] = {"beam": 1e-60, "pbeam": 1e-60, "compallsen": True, "bestpath": False, "loglevel": "FATAL"}
"""Wide beams: what is said may be unlike all that is sought, and that is the question."""

RIVALS = 15
"""Words that compete with each word of a phrase."""

SCALE = 1024.0
"""The library's scores are natural logarithms over this."""

AROUND = (BEFORE + BEHIND) // HOP
"""Frames of an utterance that are the quiet around it."""

MIDDLE, SPREAD = -3.2, 0.8
"""The score, natural logarithms a frame, at which a phrase is as likely as not, and how fast that changes with it."""

SHORTEST, LONGEST, MORE = 3, 16, 30
"""Frames that a sound lasts at least and at most, and how many more a phrase may."""


class Sphinx:
    """A `Recogniser`; `sounds` says how a word is said that no dictionary has."""

    def __init__(self, phrases: Sequence[Phrase], sounds: Callable[[str], Sounds]) -> None:
        dictionary = read_dictionary(Path(get_model_path("en-us/cmudict-en-us.dict")))
        ways = {word: dictionary.get(word) or [sounds(word)] for one in phrases for word in one.words}
        self._texts = [one.text for one in phrases]
        self._lengths = [sum(len(ways[word][0]) for word in one.words) for one in phrases]
        lexicon = Lexicon()
        own = {word: lexicon.names(found) for word, found in ways.items()}
        rivals = Rivals(dictionary, _often())
        near = {word: lexicon.names_of(rivals.of(found, RIVALS), dictionary) for word, found in ways.items()}
        alone = lexicon.names_of([word for word in COMMON if word not in ways], dictionary)
        strict = [" ".join(_any(own[word]) for word in one.words) for one in phrases]
        loose = [" ".join(_any([*own[word], *near[word]]) for word in one.words) for one in phrases]
        self._strict, self._loose = lexicon.decoder(strict), lexicon.decoder([*loose, _any(alone)])
        self._sounds = Decoder(lm=None, allphone=get_model_path("en-us/en-us-phone.lm.bin"), lw=2.0, **WIDE)
        self._order = {" ".join(own[word][0] for word in one.words): at for at, one in enumerate(phrases)}
        self._same = lexicon.same
        self._heard: list[Samples] = []

    def begin(self) -> None:
        self._heard = []

    def take(self, sound: Samples) -> None:
        self._heard.append(sound)

    def end(self) -> tuple[str, float] | None:
        sound = b"".join(piece.astype("<i2").tobytes() for piece in self._heard)
        found = _best(self._strict, sound)
        frames = len(sound) // 2 // HOP - AROUND
        if found is None or frames <= 0:
            return None
        names, score = found
        number = self._order[" ".join(self._same[name] for name in names)]
        length = self._lengths[number]
        if not SHORTEST * length <= frames <= LONGEST * length + MORE:
            return None
        others = [_best(search, sound) for search in (self._loose, self._sounds)]
        behind = sum(score - (other[1] if other is not None else score) for other in others) / frames
        return self._texts[number], 1.0 / (1.0 + exp((MIDDLE - behind) / SPREAD))


class Lexicon:
    """Ways to say words under names that any grammar takes; `same` has the first name of each word."""

    def __init__(self) -> None:
        self._ways: dict[str, Sounds] = {}
        self.same: dict[str, str] = {}

    def names(self, ways: Sequence[Sounds]) -> list[str]:
        """The names of a word's ways."""
        first = len(self._ways)
        found = [f"w{first + number}" for number in range(len(ways))]
        self._ways.update(zip(found, ways, strict=True))
        self.same.update(dict.fromkeys(found, found[0]))
        return found

    def names_of(self, words: Sequence[str], dictionary: Mapping[str, Sequence[Sounds]]) -> list[str]:
        return [name for word in words for name in self.names(dictionary.get(word, ()))]

    def decoder(self, rules: Sequence[str]) -> Any:
        """One that hears one of the rules."""
        decoder = Decoder(lm=None, dict=None, wbeam=1e-40, **WIDE)
        for number, (name, sounds) in enumerate(self._ways.items(), 1):
            decoder.add_word(name, " ".join(sounds), number == len(self._ways))
        decoder.add_jsgf_string("phrases", f"#JSGF V1.0;\ngrammar phrases;\npublic <said> = {' | '.join(rules)};\n")
        decoder.activate_search("phrases")
        return decoder


def _any(names: Sequence[str]) -> str:
    return f"({' | '.join(names)})"


def _best(decoder: Any, sound: bytes) -> tuple[list[str], float] | None:
    """The words of the best way through an utterance, and its score; None where there is none."""
    decoder.start_utt()
    decoder.process_raw(sound, full_utt=True)
    decoder.end_utt()
    found = decoder.hyp()
    if found is None or not found.hypstr or found.score <= 0.0:
        return None
    return found.hypstr.split(), SCALE * log(found.score)


def _often() -> Any:
    """How often words are said, as a logarithm."""
    model = NGramModel(Config(), LogMath(), get_model_path("en-us/en-us.lm.bin"))
    return lambda word: model.prob([word])
