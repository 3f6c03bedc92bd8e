"""JSON of words, phones and marks to times and back: our own form, and those of voices and recognisers."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any

from facescript.speech.model import PhoneTime
from facescript.speech.timing.alphabets import is_silence, is_unspoken, to_ipa
from facescript.speech.timing.rhubarb import from_cues
from facescript.speech.timing.times import TimedMark, TimedWord, Times, closed, moment, stretch, times_of, unusable

DEEPEST = 12
"""Brackets inside brackets of a JSON file that are followed."""

_TEXTS, _STARTS, _ENDS = ("text", "word", "t", "label"), ("start", "b", "begin"), ("end",)
_SURE = ("confidence", "score", "probability", "conf", "p")
_LENGTHS = ("d", "duration")
"""What recognisers call the parts of a word: Whisper, Vosk, Gentle, pocketsphinx."""

_KINDS = {1: "word", 2: "sentence", 3: "mark", 4: "play", 5: "end", 6: "end", 7: "phoneme"}
"""espeak-ng's numbers of events."""

_INSIDE = ("segments", "fragments", "result", "results", "tiers", "alternatives")


def is_json(text: str) -> bool:
    return text.lstrip()[:1] in ("{", "[")


def read_json(text: str) -> Times:
    """Any of the forms. Raises `VoiceFailure`."""
    value = _parsed(text)
    if isinstance(value, list):
        value = {"phoneme_alignments" if _all_have(value, "num_samples") else "words": value}
    if not isinstance(value, dict):
        raise unusable("the JSON is neither an object nor a list")
    if "mouthCues" in value:
        return from_cues(_list(value, "mouthCues"), _duration(value.get("metadata") or {}))
    if "phoneme_alignments" in value or "chunks" in value:
        return _from_samples(value)
    if "events" in value:
        return _from_events(value)
    if "w" in value:
        return _from_nested(value)
    return _from_words(value)


def _parsed(text: str) -> Any:
    try:
        return json.loads(text)
    except json.JSONDecodeError as fault:
        raise unusable(f"it is no JSON: {fault.msg[:1].lower()}{fault.msg[1:]}", fault.lineno) from None
    except RecursionError:
        raise unusable("its brackets stand too deep in each other") from None
    except ValueError:
        raise unusable("a number in it is too long") from None


def _list(value: Mapping[str, Any], name: str) -> Sequence[Any]:
    found = value.get(name, [])
    if not isinstance(found, list):
        raise unusable(f"`{name}` is no list")
    return found


def _all_have(entries: Sequence[Any], name: str) -> bool:
    return bool(entries) and all(isinstance(entry, dict) and name in entry for entry in entries)


def _duration(value: Any) -> float:
    found = value.get("duration") if isinstance(value, dict) else None
    return moment(found) if found is not None else 0.0


# ------------------------------------------------------------------------------------ words, phones and marks


def _from_words(value: Mapping[str, Any]) -> Times:
    """Our own form; words may also stand in segments, as recognisers write them."""
    words = [_word(number, entry) for number, entry in enumerate(_words_in(value, 0), 1)]
    phones = _list(value, "phones")
    labels = [_text(number, "phone", entry, ("symbol", "phone", *_TEXTS)) for number, entry in enumerate(phones, 1)]
    sounds = [
        PhoneTime(symbol, *_stretch(number, "phone", entry), stress or entry.get("stress") is True)
        for number, (entry, (symbol, stress)) in enumerate(zip(phones, to_ipa(labels), strict=True), 1)
    ]
    marks = [_mark(number, entry) for number, entry in enumerate(_list(value, "marks"), 1)]
    return times_of([word for word in words if word is not None], sounds, marks, _duration(value))


def _words_in(value: Mapping[str, Any], depth: int) -> Iterator[Any]:
    if depth > DEEPEST:
        raise unusable("its brackets stand too deep in each other")
    if "words" in value:
        yield from _list(value, "words")
        return
    for name in _INSIDE:
        if isinstance(value.get(name), list):
            for entry in value[name]:
                if isinstance(entry, dict) and ("words" in entry or any(key in entry for key in _INSIDE)):
                    yield from _words_in(entry, depth + 1)
                else:
                    yield entry
            return


def _word(number: int, entry: Any) -> TimedWord | None:
    """A word; None for one that its recogniser did not find, or a silence."""
    text = _text(number, "word", entry, _TEXTS)
    if is_unspoken(text) or not any(name in entry for name in _STARTS):
        return None
    sure = _first(entry, _SURE)
    share = min(moment(sure), 1.0) if sure is not None else 1.0
    return TimedWord(" ".join(text.split()), *_stretch(number, "word", entry), share)


def _mark(number: int, entry: Any) -> TimedMark:
    return TimedMark(_text(number, "mark", entry, ("name", *_TEXTS)), moment(_first(entry, ("time", *_STARTS))))


def _first(entry: Mapping[str, Any], names: Sequence[str]) -> Any:
    return next((entry[name] for name in names if name in entry), None)


def _text(number: int, kind: str, entry: Any, names: Sequence[str]) -> str:
    found = _first(entry, names) if isinstance(entry, dict) else None
    if not isinstance(found, str):
        raise unusable(f"{kind} {number} has no `{names[0]}`")
    return found


def _stretch(number: int, kind: str, entry: Mapping[str, Any]) -> tuple[float, float]:
    start, end, length = _first(entry, _STARTS), _first(entry, _ENDS), _first(entry, _LENGTHS)
    if start is None or (end is None and length is None):
        raise unusable(f"{kind} {number} has no `start` and `end`")
    return stretch(start, end if end is not None else moment(start) + moment(length))


def _from_nested(value: Mapping[str, Any]) -> Times:
    """pocketsphinx: words in a line, phones in words."""
    entries = _list(value, "w")
    words = [_word(number, entry) for number, entry in enumerate(entries, 1)]
    kept = [TimedWord(word.text.split("(")[0], word.start, word.end, word.confidence) for word in words if word]
    inner = [phone for entry in entries if isinstance(entry, dict) for phone in _list(entry, "w")]
    sounds = to_ipa([_text(number, "phone", entry, _TEXTS) for number, entry in enumerate(inner, 1)])
    phones = [
        PhoneTime(symbol, *_stretch(number, "phone", entry), stress)
        for number, (entry, (symbol, stress)) in enumerate(zip(inner, sounds, strict=True), 1)
    ]
    return times_of(kept, phones, duration=moment(value["d"]) if "d" in value else 0.0)


# ------------------------------------------------------------------------------------ what voices tell of


def _from_samples(value: Mapping[str, Any]) -> Times:
    """piper: each phoneme's number of samples, in chunks one after another; what stands between spaces is a word."""
    chunks = _list(value, "chunks") if "chunks" in value else [value]
    entries: list[tuple[str, float]] = []
    for chunk in chunks:
        if not isinstance(chunk, dict):
            raise unusable("a chunk is no object")
        rate = _number(chunk.get("sample_rate", value.get("sample_rate", 22_050)))
        for number, entry in enumerate(_list(chunk, "phoneme_alignments"), 1):
            symbol = _text(number, "phoneme", entry, ("phoneme",))
            entries.append((symbol, moment(_number(entry.get("num_samples")) / max(rate, 1.0))))
    return _from_lengths(entries)


def _from_lengths(entries: Sequence[tuple[str, float]]) -> Times:
    """Phonemes one after another: a stress belongs to what follows, a length to what is before, and all that is no
    letter is silence."""
    phones: list[PhoneTime] = []
    words: list[TimedWord] = []
    at, stressed, inside = 0.0, "", False
    for symbol, length in entries:
        end = moment(at + length)
        if symbol in ("ˈ", "ˌ"):
            stressed = symbol
        elif symbol in ("ː", "ˑ") and phones:
            phones[-1] = replace(phones[-1], symbol=phones[-1].symbol + symbol, end=end)
        else:
            sound = any(map(str.isalpha, symbol))
            phones.append(PhoneTime(symbol if sound else "", phones[-1].end if phones else 0.0, end, stressed == "ˈ"))
            if sound and not inside:
                words.append(TimedWord("", at, end))
            stressed, inside = "", sound
        if inside:
            words[-1] = replace(words[-1], end=end)
        at = end
    return times_of(words, phones, duration=at)


def _number(value: Any) -> float:
    """A number that is no time: samples, or samples a second."""
    if isinstance(value, bool) or not isinstance(value, int | float) or not 0 <= value < 1e12:
        raise unusable(f"`{str(value)[:40]}` is no number of samples")
    return float(value)


def _from_events(value: Mapping[str, Any]) -> Times:
    """espeak-ng's events with the text they are of: `type`, `audio_position` in ms or `sample`, `id` of a phoneme."""
    text, rate = value.get("text", ""), _number(value.get("sample_rate", 22_050))
    if not isinstance(text, str) or not rate:
        raise unusable("`text` is no text, or `sample_rate` no rate")
    found = [_event(number, entry, rate) for number, entry in enumerate(_list(value, "events"), 1)]
    last = max([_duration(value), *(time for _, time, _ in found)])
    words = [(time, _spoken(text, entry)) for kind, time, entry in found if kind == "word"]
    sounds = [(time, _symbol(entry)) for kind, time, entry in found if kind == "phoneme"]
    marks = [TimedMark(_symbol(entry), time) for kind, time, entry in found if kind == "mark"]
    ends = [time for time, _ in sounds[1:]] + [last]
    phones = [
        PhoneTime(symbol, time, max(time, end), stress)
        for (time, _), end, (symbol, stress) in zip(sounds, ends, to_ipa([name for _, name in sounds]), strict=True)
    ]
    limits = [time for time, _ in words[1:]] + [last]
    spoken = [
        TimedWord(word, time, _word_end(phones, time, max(time, limit)))
        for (time, word), limit in zip(words, limits, strict=True)
    ]
    return times_of(spoken, closed(phones), marks, last)


def _event(number: int, entry: Any, rate: float) -> tuple[str, float, Mapping[str, Any]]:
    if not isinstance(entry, dict):
        raise unusable(f"event {number} is no object")
    kind = _KINDS.get(entry.get("type"), entry.get("type"))  # type: ignore[arg-type]
    if "sample" in entry:
        return str(kind), moment(_number(entry["sample"]) / rate), entry
    if "audio_position" not in entry:
        raise unusable(f"event {number} has no `audio_position` or `sample`")
    return str(kind), moment(_number(entry["audio_position"]) / 1000), entry


def _spoken(text: str, entry: Mapping[str, Any]) -> str:
    """The word of an event: its `text_position` counts characters from 1."""
    at, length = entry.get("text_position"), entry.get("length")
    if not isinstance(at, int) or not isinstance(length, int) or at < 1:
        raise unusable("a word event has no `text_position` and `length`")
    return text[at - 1 : at - 1 + length].strip() or "?"


def _symbol(entry: Mapping[str, Any]) -> str:
    name = entry.get("id")
    name = _first(name, ("string", "name")) if isinstance(name, dict) else name
    if not isinstance(name, str):
        raise unusable("an event has no `id`")
    return "" if name.startswith("(") or is_silence(name) else name


def _word_end(phones: Sequence[PhoneTime], start: float, limit: float) -> float:
    """The end of the last sound before the next word."""
    return max((p.end for p in phones if p.symbol and start <= p.start < limit), default=limit)


# ------------------------------------------------------------------------------------ writing


def write_json(times: Times) -> str:
    """Our own form, a line a word, phone or mark."""
    words = [
        {"text": word.text, "start": _kept(word.start), "end": _kept(word.end), "confidence": _kept(word.confidence)}
        for word in times.words
    ]
    phones = [
        {"symbol": phone.symbol, "start": _kept(phone.start), "end": _kept(phone.end)}
        | ({"stress": True} if phone.stress else {})
        for phone in times.phones
    ]
    marks = [{"name": mark.name, "time": _kept(mark.time)} for mark in times.marks]
    lists = ",\n".join(
        f'  "{name}": [\n' + ",\n".join("    " + json.dumps(entry, ensure_ascii=False) for entry in entries) + "\n  ]"
        for name, entries in (("words", words), ("phones", phones), ("marks", marks))
        if entries
    )
    return f'{{\n  "duration": {_kept(times.duration)},\n{lists}\n}}\n'


def _kept(seconds: float) -> float:
    return round(seconds, 6)
