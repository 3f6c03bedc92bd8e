"""Texts of lines: marks to plain text, stretches and cues; words; and faults at their exact place."""

from __future__ import annotations

from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st
from plays import codes, resolved, verb, verbs, when

from facescript.ir.acts import Add, Do, Say
from facescript.ir.wording import find, occurrences, words


def said(text: str, root: Path | None = None) -> Say:
    (line,) = verbs(text, root)
    assert isinstance(line, Say)
    return line


def cues(line: Say) -> list[str]:
    found = []
    for cue in line.cues:
        (node,) = cue.body.items
        assert isinstance(node, Do)
        found.append(f"{when(cue)}: {verb(node.verb).split(' [')[0]}")
    return found


def test_a_text_behind_a_name_is_read_where_it_was_written() -> None:
    text = (
        "target cup at 0cm 0cm 30cm\naction tell(who, words):\n    say words\n"
        'let hello = "Hello, *you*."\ntell cup, words "My [look at cup]cup[/]."\nsay hello\ntell cup, words hello\n'
    )
    lines = [node for node in verbs(text) if isinstance(node, Say)]
    assert [line.text for line in lines] == ["My cup.", "Hello, you.", "Hello, you."]
    assert cues(lines[0]) == ["before 3 until 6: look target cup"]


def test_a_text_in_a_cell_is_told_of_by_its_row(tmp_path: Path) -> None:
    (tmp_path / "lines.csv").write_text('text\n"Well, [smile 40%]hello[/]"\nGood bye [smlie]\n', "utf-8")
    text = 'repeat row in "lines.csv":\n    say row.text\n'
    (told,) = resolved(text, tmp_path)[1]
    assert told.code == "FS204" and told.span is not None
    assert (told.span.source.name, told.span.text) == ("lines.csv row 2 text", "smlie")


def test_a_page_of_marks() -> None:
    line = said('say "Good [brows 50%]evening[/], everyone. | I have lost my *cup*.[wait 300ms]"\n')
    assert line.text == "Good evening, everyone. I have lost my cup."
    assert [(s.kind, line.text[s.start : s.end], s.value) for s in line.stretches] == [
        ("breath", "", ""),
        ("stress", "cup", ""),
        ("pause", "", "0.3"),
    ]
    assert cues(line) == ["before 5 until 12: add 0.5 brows"]


def test_a_bracket_without_a_verb_lasts_to_the_end_of_the_line_one_with_a_verb_by_itself() -> None:
    assert cues(said('say "One [smile 40%]two [nod]three."\n')) == [
        "before 4 until 14: add 0.4 smile",
        "before 8: nod 1 of 1 nodding",
    ]
    assert cues(said('say "One [look left 20deg]two[/] three."\n')) == ["before 4 until 7: look towards 20 0 deg"]


def test_the_closing_bracket_closes_what_was_opened_last() -> None:
    line = said('say "[smile 50%]a [brows 60%]b[/] c[/] d"\n')
    assert cues(line) == ["before 0 until 5: add 0.5 smile", "before 2 until 3: add 0.6 brows"]


def test_brackets_take_sums_timings_and_actions() -> None:
    text = 'action bow(depth):\n    nod depth\nsay "[smile 40% + AU4 10% for 2s]a [bow 30%]b"\n'
    line = verbs(text)[0]
    assert isinstance(line, Say)
    first = line.cues[0].body.items[0]
    assert isinstance(first, Do)
    assert isinstance(first.verb, Add)
    assert (len(first.verb.mix.terms), first.verb.timing.lasting) == (2, 2.0)
    assert len(line.cues) == 2


def test_readings() -> None:
    line = said('say "小明在[read zhang3]长[/]大，[read chong2 xin1]重新[/]。"\n')
    assert [(s.value, line.text[s.start : s.end]) for s in line.stretches] == [
        ("zhang3", "长"),
        ("chong2 xin1", "重新"),
    ]


def test_signs_may_be_escaped() -> None:
    assert said(r'say "A \[sign\] \* \| \"quoted\" \\."' + "\n").text == 'A [sign] * | "quoted" \\.'


def test_further_strings_go_on_after_a_space_where_the_script_has_spaces() -> None:
    assert said('say "One,"\n    "two."\n').text == "One, two."
    assert said('say "他说："\n    "「好。」"\n').text == "他说：「好。」"


def test_a_stress_may_reach_over_marks_and_strings() -> None:
    line = said('say "a *b [nod]c"\n    "d* e"\n')
    assert [line.text[s.start : s.end] for s in line.stretches] == ["b c d"]


def test_text_from_a_file(tmp_path: Path) -> None:
    (tmp_path / "take.txt").write_text("Hello,\n  [smile 20%]world[/].\n", "utf-8")
    line = said('say text "take.txt"\n', tmp_path)
    assert line.text == "Hello, world."
    (tmp_path / "take.txt").write_text("Hello,\n  [smle]world.\n", "utf-8")
    (item,) = resolved('say text "take.txt"\n', tmp_path)[1]
    assert item.span is not None
    assert (item.code, item.span.source.name, item.span.source.position(item.span.start)) == (
        "FS204",
        "take.txt",
        (2, 4),
    )


def test_rates_are_factors_of_the_voice() -> None:
    line = said('face ada = woman, voice en-gb female, rate 90%, volume 50%\nsay "Hello.", rate 80%, pitch 110%\n')
    assert (line.voice.language, line.voice.variant) == ("en-gb", "female")
    assert (line.voice.rate, line.voice.pitch, line.voice.volume) == pytest.approx((0.72, 1.1, 0.5))


@pytest.mark.parametrize(
    ("text", "code", "marked"),
    [
        ('say "Good [brows 50% evening."', "FS315", "["),
        ('say "Good evening[/]."', "FS316", "[/]"),
        ('say "A *big dog."', "FS317", "*"),
        (r'say "One\nTwo."', "FS318", r"\n"),
        ('say "A [read zhang3]b"', "FS315", "[read zhang3]"),
        ('say "A [smle 40%]b."', "FS204", "smle"),
        ('say "A [show smle]b."', "FS201", "smle"),
        ('say "A [wait 300]b."', "FS301", "300"),
        ('say "A [look at lamb]b."', "FS202", "lamb"),
        ('say "[nod]"', "FS320", 'say "[nod]"'),
        ('say "A [say c]b."', "FS312", "say c"),
        ('say "A [nod as c]b."', "FS312", "as"),
    ],
)
def test_faults_point_at_their_place(text: str, code: str, marked: str) -> None:
    (item,) = resolved(text + "\n")[1]
    assert item.span is not None
    assert (item.code, item.span.text) == (code, marked)


def test_every_fault_of_a_text_is_told() -> None:
    assert codes('say "A [smle]b[/] [/] c\\q [show smyle]d*."\n') == ["FS316", "FS318", "FS317"]
    assert codes('say "A [smle]b[/] c [show smyle]d."\n') == ["FS204", "FS201"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('say "A cup."\n    on "cap": nod\n', "FS228"),
        ('say "A cup."\n    on "cup".2: nod\n', "FS229"),
        ('say "长城。"\n    on "城长": nod\n', "FS228"),
        ('say "A cup."\n    on "up": nod\n', "FS228"),
    ],
)
def test_words_that_are_not_said(text: str, code: str) -> None:
    assert codes(text) == [code]


def test_words_compare_without_case_and_punctuation() -> None:
    assert find("Look! A banana, look.", "look", 2) == (16, 20)
    assert find("Look! A banana, look.", "LOOK") == (0, 4)
    assert find("votes to thirty-one, to", "thirty-one") == (9, 19)
    assert find("by two point four percent", "two point four") == (3, 17)
    assert find("don't, they said", "don't") == (0, 5)
    assert find("小明在长城脚下长大", "长", 3) is None
    assert find("小明在长城脚下长大", "长", 2) == (7, 8)
    assert occurrences("cup cups", "cup") == ((0, 3),)


@given(st.text(max_size=60))
def test_every_word_of_a_text_is_found_in_it(text: str) -> None:
    for bare, first, last in words(text):
        assert bare
        assert (first, last) in occurrences(text, text[first:last]) or find(text, text[first:last]) is not None


plain = st.text(alphabet=st.characters(blacklist_categories=["Cs", "Cc", "Zl", "Zp"]), min_size=1, max_size=40)


@given(plain)
def test_escaped_text_comes_back_as_it_is(text: str) -> None:
    escaped = "".join(f"\\{sign}" if sign in '[]*|"\\' else sign for sign in text)
    bare = " ".join(text.split())
    if bare:
        assert said(f'say "{escaped}"\n').text == bare
