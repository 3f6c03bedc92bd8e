"""Files of SSML: what a line takes from them, what is told at its place in the file, and what is refused."""

from __future__ import annotations

from pathlib import Path
from time import process_time

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from plays import resolved, verbs

from facescript.compile import compile_source
from facescript.ir.acts import Say
from facescript.speech.estimate import EstimatedVoice
from facescript.text import Source
from facescript.world import World

SCRIPT = 'face ada = woman, voice en-gb\nsay ssml "a.ssml"\n'


def said(folder: Path, body: str) -> tuple[Say, list[str]]:
    """The line that a file of SSML makes, and what was told: code, line, column, text."""
    (folder / "a.ssml").write_text(body, "utf-8")
    line = verbs(SCRIPT, folder)[-1]
    assert isinstance(line, Say)
    return line, told(folder)


def told(folder: Path) -> list[str]:
    found = []
    for item in resolved(SCRIPT, folder)[1]:
        assert item.span is not None
        line, column = item.span.source.position(item.span.start)
        found.append(f"{item.code} {item.span.source.name}:{line}:{column} {item.message}")
    return found


def marks(line: Say) -> list[tuple[str, str, str]]:
    return [(s.kind, line.text[s.start : s.end] or str(s.start), s.value) for s in line.stretches]


def test_tags_become_what_a_text_can_hold(tmp_path: Path) -> None:
    body = """<?xml version="1.0"?>
<!-- a comment --><speak version="1.1" xml:lang="en-US" xmlns="http://www.w3.org/2001/10/synthesis">
  Good &lt;evening&gt;,  <emphasis level="strong">everyone</emphasis>.<break time="1500ms"/>
  The <sub alias="World Wide Web">W3C</sub> &amp; <phoneme alphabet="ipa" ph="təˈmɑːtəʊ">tomato</phoneme>
  <phoneme alphabet="x-sampa" ph="S@">sh</phoneme> <say-as interpret-as="characters">BBC</say-as><mark name="end"/>
</speak>"""
    line, told_of = said(tmp_path, body)
    assert line.text == "Good <evening>, everyone. The W3C & tomato sh BBC"
    assert marks(line) == [
        ("stress", "everyone", ""),
        ("pause", "25", "1.5"),
        ("reading", "W3C", "World Wide Web"),
        ("reading", "tomato", "/təˈmɑːtəʊ/"),
        ("reading", "sh", "/ʃə/"),
        ("reading", "BBC", "B B C"),
        ("mark", "49", "end"),
    ]
    assert told_of == []


def test_sentences_without_their_sign_end_in_a_breath(tmp_path: Path) -> None:
    line, _ = said(tmp_path, "<speak><s>One</s><s>Two.</s><s>Three</s>\n<p>Four.</p><p>你好</p><p>再见</p></speak>")
    assert line.text == "One Two. Three Four. 你好 再见"
    assert [start for kind, start, _ in marks(line) if kind == "breath"] == ["3", "14", "20", "23"]


def test_prosody_around_all_of_it_is_the_lines(tmp_path: Path) -> None:
    line, told_of = said(
        tmp_path, '<speak> <prosody rate="fast" pitch="+12st" volume="-6dB"><s>One.</s></prosody></speak>'
    )
    assert (line.voice.rate, line.voice.pitch) == (1.25, 2) and line.voice.volume == pytest.approx(0.5, abs=0.01)
    assert told_of == []


def test_a_recording_keeps_its_rate_and_melody(tmp_path: Path) -> None:
    (tmp_path / "take.wav").write_bytes(b"")
    (tmp_path / "a.ssml").write_text('<speak><prosody rate="slow" pitch="high" volume="-6dB">One.</prosody></speak>')
    script = SCRIPT.replace("\n", ' from "take.wav"\n').replace(' from "take.wav"\n', "\n", 1)
    line = verbs(script, tmp_path)[-1]
    assert isinstance(line, Say) and line.voice.rate == line.voice.pitch == 1 and line.voice.volume < 0.6
    assert [item.code for item in resolved(script, tmp_path)[1]] == ["FS518", "FS518"]


def test_what_a_line_cannot_do_is_told_where_it_stands(tmp_path: Path) -> None:
    body = (
        '<speak xml:lang="de">\nOne <prosody rate="slow">two</prosody>\n<voice name="x">three</voice> <blink>4</blink>'
        '\n<audio src="a.wav">five</audio> <desc>never</desc> <prosody>six</prosody>'
        '<emphasis level="reduced">7</emphasis></speak>'
    )
    line, told_of = said(tmp_path, body)
    assert line.text == "One two three 4 five six7"
    assert [text.split(" ")[:2] for text in told_of] == [
        ["FS518", "a.ssml:3:31"],
        ["FS518", "a.ssml:4:1"],
        ["FS518", "a.ssml:4:33"],
        ["FS518", "a.ssml:4:74"],
        ["FS518", "a.ssml:2:5"],
        ["FS518", "a.ssml:3:1"],
        ["FS519", "script.face:2:1"],
    ]


def test_marks_are_places_for_statements(tmp_path: Path) -> None:
    body = '<speak>One <mark name="here now"/>two.<mark name="two"/><break time="2s"/> Three two</speak>'
    (tmp_path / "a.ssml").write_text(body, "utf-8")
    script = 'say ssml "a.ssml" as line\n    on "here now": nod\n    on "two": shake\nat line."two".end: blink\n'
    score = compile_source(Source("x.face", script), World(tmp_path), EstimatedVoice()).score
    assert score is not None
    first, two, three, _ = score.lines[0].spoken.words
    found = {type(act.verb).__name__ + getattr(act.verb, "kind", ""): act.start for act in score.acts}
    assert found["Gesturenod"] == two.start and found["Gestureshake"] == found["Gestureblink"] == two.end
    assert three.start >= two.end + 2 and first.start < two.start
    wrong = compile_source(
        Source("x.face", 'say ssml "a.ssml"\n    on "nowhere": nod\n'), World(tmp_path), EstimatedVoice()
    )
    assert [item.code for item in wrong.diagnostics] == ["FS228"]


BOMB = '<?xml version="1.0"?>\n<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>\n<speak>&b;</speak>'


@pytest.mark.parametrize(
    ("body", "place", "reason"),
    [
        (BOMB, "2:1", "document type"),
        ('<!DOCTYPE speak SYSTEM "file:///etc/passwd"><speak>a</speak>', "1:1", "document type"),
        ("<speak>\na&nbsp;b</speak>", "2:2", "undefined entity"),
        ("<speak>a<s></speak>", "1:14", "mismatched tag"),
        ("<speak>a", "1:9", "no element found"),
        ("hello", "1:1", "syntax error"),
        ("<voice>a</voice>", "1:1", "begins with `<voice>`"),
        ("<speak>" + "<s>" * 99 + "a" + "</s>" * 99 + "</speak>", "1:197", "64 deep"),
        ('<speak>a<break time="soon"/></speak>', "1:9", "`500ms`"),
        ("<speak>a<mark/></speak>", "1:9", "no `name`"),
    ],
)
def test_bad_files_are_refused_at_their_place(tmp_path: Path, body: str, place: str, reason: str) -> None:
    (tmp_path / "a.ssml").write_text(body, "utf-8")
    (fault,) = told(tmp_path)
    assert fault.startswith(f"FS517 a.ssml:{place} ") and reason in fault


def test_empty_and_endless_texts_are_refused(tmp_path: Path) -> None:
    for body, code in (("<speak> <s/> </speak>", "FS320"), (f"<speak>{'word ' * 9000}</speak>", "FS319")):
        (tmp_path / "a.ssml").write_text(body, "utf-8")
        assert [fault[:5] for fault in told(tmp_path)] == [code]


def test_many_strange_tags_end_soon(tmp_path: Path) -> None:
    body = "".join(f"<x{number}/>" for number in range(60_000))
    (tmp_path / "a.ssml").write_text(f"<speak>a{body}</speak>", "utf-8")
    begun = process_time()
    assert len(told(tmp_path)) < 40 and process_time() - begun < 1


@settings(max_examples=30, deadline=None)
@given(body=st.text(alphabet='<>/&;"= speakbrm!-[]?\n\x00é', max_size=40))
def test_any_file_is_read_or_refused(body: str, tmp_path_factory: pytest.TempPathFactory) -> None:
    folder = tmp_path_factory.getbasetemp()
    for text in (body, f"<speak>{body}</speak>"):
        (folder / "a.ssml").write_text(text, "utf-8")
        told(folder)
