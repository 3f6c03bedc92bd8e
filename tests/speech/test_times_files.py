"""Files of times are read as their makers meant them; what is written can be read back; what is broken is told."""

from __future__ import annotations

import json
from contextlib import suppress
from pathlib import Path

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from facescript.speech.model import PhoneTime, VoiceFailure
from facescript.speech.timing.files import WRITERS, read_times, write_times
from facescript.speech.timing.times import TimedMark, TimedWord, Times, closed, released, times_of

SHARED = Path(__file__).parents[2].parent / "shared" / "data" / "speech"


def read(text: str, name: str = "take") -> Times:
    return read_times(name, text.encode())


def spoken(times: Times) -> list[tuple[str, float, float]]:
    return [(word.text, round(word.start, 3), round(word.end, 3)) for word in times.words]


def symbols(times: Times) -> list[str]:
    return [phone.symbol for phone in times.phones if phone.symbol]


# ------------------------------------------------------------------------------------ there and back

WORDS = st.sampled_from(["hello", "don't", "世", "界", "2.4", "naïve", "été", "Κύπρος", "你"])
SYMBOLS = st.sampled_from(["h", "ə", "l", "oʊ", "tʃ", "ɡ", "m", "ɑː", ""])


@st.composite
def some_times(draw: st.DrawFn) -> Times:
    words: list[TimedWord] = []
    phones: list[PhoneTime] = []
    at = 0
    for _ in range(draw(st.integers(1, 12))):
        at += draw(st.sampled_from([0, 0, 40, 900]))
        end = at + draw(st.integers(30, 700))
        words.append(TimedWord(draw(WORDS), at / 1000, end / 1000, draw(st.sampled_from([1.0, 0.25, 0.873]))))
        middle = (at + end) // 2
        phones.append(PhoneTime(draw(SYMBOLS), at / 1000, middle / 1000))
        phones.append(PhoneTime(draw(SYMBOLS), middle / 1000, end / 1000, draw(st.booleans())))
        at = end
    marks = [TimedMark(name, draw(st.integers(0, at)) / 1000) for name in draw(st.lists(WORDS, max_size=2))]
    heard = [phone if phone.symbol else PhoneTime("", phone.start, phone.end) for phone in phones]
    return times_of(words, heard if draw(st.booleans()) else (), marks, (at + draw(st.sampled_from([0, 500]))) / 1000)


def close(first: float, second: float) -> bool:
    return abs(first - second) < 2e-4


@settings(max_examples=30, deadline=None)
@given(times=some_times(), suffix=st.sampled_from([".TextGrid", ".json", ".vtt", ".srt", ".csv"]))
def test_what_is_written_is_read_back(times: Times, suffix: str) -> None:
    assume(suffix != ".srt" or len(times.words) > 1)
    back = read_times(f"take{suffix}", write_times(times, suffix))
    assert [word.text for word in back.words] == [word.text for word in times.words]
    assert all(close(a.start, b.start) and close(a.end, b.end) for a, b in zip(times.words, back.words, strict=True))
    if suffix in (".TextGrid", ".json", ".csv"):
        assert [word.confidence for word in back.words] == [word.confidence for word in times.words]
    if suffix in (".TextGrid", ".json"):
        assert [(p.symbol, p.stress) for p in back.phones] == [(p.symbol, p.stress) for p in times.phones]
        assert all(
            close(a.start, b.start) and close(a.end, b.end) for a, b in zip(times.phones, back.phones, strict=True)
        )
        assert [mark.name for mark in back.marks] == [mark.name for mark in times.marks]
        assert close(back.duration, times.duration)


@settings(max_examples=20, deadline=None)
@given(times=some_times())
def test_rhubarb_keeps_the_shapes(times: Times) -> None:
    if times.phones:
        shapes = read_times("take.tsv", write_times(times, ".tsv"))
        again = read_times("take.tsv", write_times(shapes, ".tsv"))
        assert symbols(again) == symbols(shapes)
        assert abs(shapes.duration - times.duration) < 0.01


@settings(max_examples=50, deadline=None)
@given(
    kind=st.sampled_from([".TextGrid", ".json", ".vtt", ".srt", ".csv", ".tsv"]),
    cut=st.floats(0, 1),
    junk=st.text(alphabet='\x00"<>-:,\t\n{}[]0123456789.eabc٣²∞', max_size=8),
)
def test_broken_files_are_told_and_nothing_else(kind: str, cut: float, junk: str) -> None:
    whole = write_times(
        times_of([TimedWord("hello", 0.1, 0.5), TimedWord("you", 0.7, 1.0)], [PhoneTime("h", 0.1, 0.5)]), kind
    ).decode()
    at = int(cut * len(whole))
    for text in (whole[:at] + junk, whole[:at] + junk + whole[at:]):
        with suppress(VoiceFailure):
            read_times(f"take{kind}", text.encode())


# ------------------------------------------------------------------------------------ TextGrid

SHORT = '''File type = "ooTextFile"
Object class = "TextGrid"

1.5
3
<exists>
2
"IntervalTier"
"{phones}"
1.5
3
4
1.5
1.7
""
1.7
1.8
"{first}"
1.8
2.0
"{second}"
2.0
3
"sil"
"IntervalTier"
"{words}"
1.5
3
3
1.5
1.7
""
1.7
2
"he ""said"""
2
3
""
'''


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "utf-16-be"])
@pytest.mark.parametrize(("first", "second"), [("HH", "IY1"), ("h", "ˈi"), ("h", '""i')])
def test_short_textgrid_in_any_coding_and_alphabet(encoding: str, first: str, second: str) -> None:
    text = SHORT.format(first=first, second=second, phones="ada - phones", words="ada - words")
    times = read_times("take.TextGrid", text.encode(encoding))
    assert spoken(times) == [('he "said"', 0.2, 0.5)]
    assert [(p.symbol, p.stress) for p in times.phones] == [("", False), ("h", False), ("i", True), ("", False)]
    assert times.duration == 1.5


def test_tiers_without_names_are_told_by_what_is_in_them() -> None:
    times = read(SHORT.format(first="HH", second="IY1", phones="1", words="2"))
    assert spoken(times) == [('he "said"', 0.2, 0.5)] and symbols(times) == ["h", "i"]


def test_alphabets_are_told_apart_as_a_whole() -> None:
    def of(*labels: str) -> list[str]:
        entries = [{"symbol": label, "start": at, "end": at + 1} for at, label in enumerate(labels)]
        return symbols(read(json.dumps({"phones": entries})))

    assert of("S", "AH0", "NG") == ["s", "ə", "ŋ"]
    assert of("S", "i:", "N", "a_~", "t`", "aI") == ["ʃ", "iː", "ŋ", "ã", "ʈ", "aɪ"]
    assert of("s", "iː", "ŋ", "t͡ʃ") == ["s", "iː", "ŋ", "t͡ʃ"]
    assert of("k", "a", "t") == ["k", "a", "t"]


def test_word_called_silence_is_a_word() -> None:
    words = [{"word": "sil", "start": 0, "end": 1}, {"word": "silence", "start": 1, "end": 2}]
    assert spoken(read(json.dumps(words))) == [("silence", 1, 2)]


@pytest.mark.skipif(not SHARED.is_dir(), reason="the shared recordings are not here")
def test_labels_of_the_shared_recordings() -> None:
    grid = read_times("a.TextGrid", (SHARED / "praatio_damon_set_test.TextGrid").read_bytes())
    assert symbols(grid)[:6] == ["d", "eɪ", "m", "ə", "n", "f"]
    sphinx = read_times("a.json", (SHARED / "pocketsphinx_sense-0880.phone.json").read_bytes())
    assert " ".join(word.text for word in sphinx.words) == "he was not an ill disposed young man"
    assert sphinx.words[1] == TimedWord("was", 0.33, 0.56, 0.986) and symbols(sphinx)[:3] == ["h", "i", "w"]


# ------------------------------------------------------------------------------------ JSON, Rhubarb, tables


def test_recognisers_words_are_read() -> None:
    whisper = {"segments": [{"words": [{"word": " Good", "start": 0.1, "end": 0.4, "probability": 0.9}]}]}
    vosk = {"result": [{"word": "good", "start": 0.1, "end": 0.4, "conf": 0.5}], "text": "good"}
    assert read(json.dumps(whisper)).words == (TimedWord("Good", 0.1, 0.4, 0.9),)
    assert read(json.dumps(vosk)).words == (TimedWord("good", 0.1, 0.4, 0.5),)


def test_piper_alignments_follow_each_other() -> None:
    rows = [("^", 200), ("ˈ", 50), ("h", 150), ("i", 300), ("ː", 100), (" ", 200), ("b", 500), ("$", 500)]
    entries = [{"phoneme": name, "phoneme_ids": [1], "num_samples": count} for name, count in rows]
    times = read(json.dumps({"sample_rate": 1000, "phoneme_alignments": entries}))
    sounds = [phone for phone in times.phones if phone.symbol]
    assert [(p.symbol, p.stress) for p in sounds] == [("h", True), ("iː", False), ("b", False)]
    assert spoken(times) == [("", 0.25, 0.8), ("", 1.0, 1.5)]


def test_espeak_events_are_read() -> None:
    events = [
        {"type": 1, "text_position": 1, "length": 2, "audio_position": 50},
        {"type": "phoneme", "id": "h", "audio_position": 50},
        {"type": 3, "id": {"name": "here"}, "sample": 22_050},
        {"type": 7, "id": "iː", "audio_position": 110},
        {"type": 7, "id": "", "audio_position": 300},
        {"type": 6, "audio_position": 1200},
    ]
    times = read(json.dumps({"text": "He.", "events": events}))
    assert spoken(times) == [("He", 0.05, 0.3)] and symbols(times) == ["h", "iː"]
    assert times.marks == (TimedMark("here", 1.0),) and times.duration == 1.2


def test_rhubarb_cues_are_shapes() -> None:
    cues = [{"start": 0.0, "end": 0.3, "value": "X"}, {"start": 0.3, "end": 0.5, "value": "D"}]
    times = read(json.dumps({"metadata": {"soundFile": "a.wav", "duration": 0.9}, "mouthCues": cues}))
    assert [(p.symbol, p.start, p.end) for p in times.phones] == [("", 0, 0.3), ("zh:a", 0.3, 0.5), ("", 0.5, 0.9)]
    assert read("0.00\tX\n0.30\tD\n0.50\tX\n0.90\tX\n").phones == times.phones


def test_table_with_other_names_and_separators() -> None:
    assert spoken(read('end;text;begin\n0.5;"a;b";0.25\n')) == [("a;b", 0.25, 0.5)]


# ------------------------------------------------------------------------------------ subtitles


def test_words_of_a_cue_without_times_fill_it_by_their_length() -> None:
    times = read("WEBVTT\n\n00:01.000 --> 00:02.000\n<v Ada>A considerably &amp; longer\n")
    assert [word.text for word in times.words] == ["A", "considerably", "longer"]
    assert times.words[0].start == 1 and times.words[-1].end == pytest.approx(2)
    assert times.words[1].end - times.words[1].start > 5 * (times.words[0].end - times.words[0].start)


def test_long_cue_is_not_drawn_out() -> None:
    assert read("1\n00:00:01,000 --> 00:00:09,000\nYes.\n").words[0].end < 2


def test_karaoke_times_are_exact() -> None:
    text = "WEBVTT\n\nx\n00:00.000 --> 00:02.000 align:start\none<00:00:00.500><c> two three</c><00:00:01.500>\n"
    assert spoken(read(text))[0] == ("one", 0, 0.5)
    assert spoken(read(text))[-1][2] == 1.5


def test_rolling_captions_are_said_once() -> None:
    text = (
        "WEBVTT\n\n00:00.000 --> 00:01.000\n \none<00:00:00.500><c> two</c>\n\n00:01.000 --> 00:01.010\none two\n\n"
        "00:01.010 --> 00:02.000\none two\nthree<00:00:01.500><c> four</c>\n"
    )
    assert [word.text for word in read(text).words] == ["one", "two", "three", "four"]


# ------------------------------------------------------------------------------------ faults


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        ("", "it is empty"),
        ("hello", "it is no TextGrid, JSON"),
        ("WEBVTT\n", "there are no words"),
        ("WEBVTT\n\n00:00:02.000 --> 00:00:01.000\nhi\n", "before it begins at 2 s (line 3)"),
        ("WEBVTT\n\n0:0 --> 5\nhi\n", "(line 3)"),
        ('{"words": [{"text": "a", "start": 1}]}', "word 1 has no `start` and `end`"),
        ('{"words": [{"text": "a", "start": NaN, "end": 2}]}', "outside 0 to 24 hours"),
        ('{"words": [', "it is no JSON"),
        ("[" * 100_000, "too deep"),
        ('{"mouthCues": [{"start": 0, "end": 1, "value": "Q"}]}', "no mouth shape"),
        ("word,start,end\nhi,soon,2\n", "`soon` is no time in seconds (line 2)"),
        ('File type = "ooTextFile"\nObject class = "TextGrid"\n0 1 <exists> 1 "IntervalTier" "w" 0 1 9e9', "line 3"),
        ('File type = "ooTextFile"\nObject class = "TextGrid"\n0 1 <exists> 1 "Interval', "closing quote (line 3)"),
    ],
)
def test_faults_are_told_with_their_line(text: str, reason: str) -> None:
    with pytest.raises(VoiceFailure) as caught:
        read(text)
    assert reason in caught.value.args[0] and caught.value.code == "FS515"


def test_bytes_that_are_no_text() -> None:
    for data in (b"RIFF\x80\xff\xfe", b"\xff\xfe\x00", b"a\0b"):
        with pytest.raises(VoiceFailure):
            read_times("take.json", data)


# ------------------------------------------------------------------------------------ plosives


def test_plosives_begin_at_their_burst_and_back() -> None:
    labelled = (PhoneTime("ə", 0, 0.2), PhoneTime("p", 0.2, 0.3), PhoneTime("a", 0.3, 0.5))
    spoken_ones = released(labelled)
    assert [round(p.start, 3) for p in spoken_ones] == [0, 0.255, 0.3] and spoken_ones[0].end == spoken_ones[1].start
    assert [round(p.start, 3) for p in closed(spoken_ones)] == [0, 0.2, 0.3]


def test_every_writer_has_its_suffix() -> None:
    assert set(WRITERS) == {".textgrid", ".json", ".vtt", ".srt", ".csv", ".tsv"}
