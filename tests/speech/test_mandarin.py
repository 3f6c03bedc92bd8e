"""Mandarin: characters to syllables with their tones, one time a character, and the thesis's mouth shapes."""

from __future__ import annotations

import pytest
from saying import line, over, phones_of, words_of

from facescript.ir.acts import Say, Stretch, Voice
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.lines import is_han, pieces
from facescript.speech.mandarin.numerals import chinese
from facescript.speech.mandarin.syllables import numbered, shapes, timed
from facescript.speech.mandarin.units import units
from facescript.speech.model import VoiceFailure

CHAPTER = (
    ("第一章。长城脚下的孩子。", ()),
    ("小明在长城脚下长大。他的奶奶常常说：「你一定要走到山的那一边。」", (("长大", "zhang3 da4"), ("一定", ""))),
    ("银行门前，人们一行一行地走过。天气很好，他还书去了。", (("还", "huan2"),)),
    (
        "他觉得很累，可是睡觉以前，他还是把那本很重的书重新读了一遍。夜里风很大，树叶沙沙地响，远处有狗在叫。",
        (("觉得", "jue2 de5"), ("睡觉", "shui4 jiao4"), ("重新", "chong2 xin1")),
    ),
    ("「我不怕，」他对自己说。", (("不怕", ""),)),
)
"""The chapter of an audio book: texts, and the stretches that are read or stressed."""


def chapter_line(text: str, marks: tuple[tuple[str, str], ...]) -> Say:
    return line(text, "cmn", *(over(text, part, "reading" if read else "stress", read) for part, read in marks))


def syllables(asked: Say) -> str:
    """The syllables of a line, as they are sent."""
    found = [
        syllable
        for piece in pieces(asked)
        if not isinstance(piece, float)
        for unit in units(piece, asked.text)
        for syllable in unit.syllables
    ]
    return " ".join(found)


class TestSpoken:
    pytestmark = pytest.mark.usefixtures("synthesiser")

    @pytest.mark.parametrize(("text", "marks"), CHAPTER)
    def test_a_chapter_has_a_time_for_every_character(
        self, text: str, marks: tuple[tuple[str, str], ...], synthesiser: None
    ) -> None:
        spoken = open_voice().speak(chapter_line(text, marks))
        assert [word.text for word in spoken.words] == [sign for sign in text if is_han(sign)]
        assert all(text[word.first : word.last] == word.text for word in spoken.words)
        assert all(word.end - word.start > 0.03 for word in spoken.words)
        starts = [word.start for word in spoken.words]
        assert starts == sorted(set(starts))

    def test_a_quoted_word_is_two_characters(self, synthesiser: None) -> None:
        text = CHAPTER[1][0]
        spoken = open_voice().speak(chapter_line(*CHAPTER[1]))
        first, last = (text.index("长城"), text.index("长城") + 2)
        assert [word.text for word in spoken.words if first <= word.first < last] == ["长", "城"]

    def test_latin_words_and_numbers_stand_among_characters(self, synthesiser: None) -> None:
        text = "我用 Python 写了25行，占10%，在2021年。"
        spoken = open_voice().speak(line(text, "cmn", variant="female"))
        assert words_of(spoken) == "我 用 Python 写 了 25 行 占 10% 在 2021 年"
        assert [phone.symbol for phone in spoken.phones if phone.symbol and not phone.symbol.startswith("zh:")] == [
            "p",
            "aɪ",
            "θ",
            "ə",
            "n",
        ]

    def test_a_comma_is_a_silence(self, synthesiser: None) -> None:
        phones = open_voice().speak(line("你好，你好。", "cmn")).phones
        silences = [phone.end - phone.start for phone in phones if not phone.symbol]
        assert len(silences) == 1
        assert silences[0] > 0.1

    def test_tones_are_heard(self, synthesiser: None) -> None:
        readings = ("ma1", "ma2", "ma3", "ma4", "ma5")
        heard = {open_voice().speak(line("马", "cmn", Stretch("reading", 0, 1, read))).pcm for read in readings}
        assert len(heard) == 5

    def test_lips_part_at_the_burst(self, synthesiser: None) -> None:
        spoken = open_voice().speak(line("爸爸。", "cmn"))
        closed, opened = spoken.phones[0], spoken.phones[1]
        assert (closed.symbol, opened.symbol) == ("zh:m", "zh:a")
        assert 0.02 < closed.end < opened.start
        assert phones_of(spoken).startswith("zh:m zh:a zh:m zh:a")


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("你好", "ni2 hao3"),
        ("一定，不是", "yi2 ding4 bu2 shi4"),
        ("绿女略儿嗯", "lv4 nv3 lve4 er2 n2"),
        ("2021年有365天", "er4 ling2 er4 yi1 nian2 you3 san1 bai3 liu4 shi2 wu3 tian1"),
        ("３％", "bai3 fen1 zhi1 san1"),
        ("臺灣", "tai2 wan1"),
    ],
)
def test_characters_to_syllables(text: str, expected: str) -> None:
    assert syllables(line(text, "cmn")) == expected


def test_a_reading_overrides_the_dictionary() -> None:
    text = "长大了，长。"
    assert syllables(line(text, "cmn", Stretch("reading", 0, 1, "chang2"))) == "chang2 da4 le5 chang2"
    assert syllables(line("重新", "cmn", Stretch("reading", 0, 2, "chóng xīn"))) == "chong2 xin1"
    assert syllables(line("Ok 1", "cmn", Stretch("reading", 3, 4, "yao1"))) == "yao1"


@pytest.mark.parametrize(
    ("read", "reason"),
    [
        ("zhang", "needs its tone"),
        ("zhang6", "needs its tone"),
        ("blah3", "`blah3` is no syllable"),
        ("zhang3 da4 ma1", "has 3 syllables and `长大` has 2 characters"),
        ("/ma/", "`/ma/` needs its tone"),
    ],
)
def test_a_reading_that_is_none(read: str, reason: str) -> None:
    with pytest.raises(VoiceFailure, match=reason) as failure:
        syllables(line("长大了", "cmn", Stretch("reading", 0, 2, read)))
    assert failure.value.code == "FS502"


@pytest.mark.parametrize(
    ("written", "number"),
    [("zhang3", "zhang3"), ("zhǎng", "zhang3"), ("Lǜ", "lv4"), ("lu:4", "lv4"), ("de0", "de5"), ("nǚ", "nv3")],
)
def test_pinyin_with_marks_and_with_numbers(written: str, number: str) -> None:
    assert numbered(written) == number


SHAPES = """
ma: m a         bo: m u o       fo: f o         ta: h' a        ti: i           tu: u           de: h' h
ne: h' h        ke: h h         ka: h a         gu: u           gei: e i        gou: o u        zhang: r a h
shi: r          zi: z           ri: r           jian: i e n     xuan: u e n     yan: i e n      yuan: u e n
biao: m i a u   liu: i o u      dui: u e i      shuang: r u a h kuai: u a i     er: h           wo: u o
ying: i h       xiong: u h      jun: u n        nve: u e        an: a n         yu: u           hao: h a u
"""


def test_syllables_to_shapes() -> None:
    names = SHAPES.replace(":", " :").split()
    rows: dict[str, list[str]] = {}
    for at, name in enumerate(names):
        if name == ":":
            row = rows[names[at - 1]] = []
        elif at + 1 == len(names) or names[at + 1] != ":":
            row.append(name)
    assert {syllable: list(shapes(f"{syllable}1")) for syllable in rows} == rows


@pytest.mark.parametrize(
    ("syllable", "expected"),
    [
        ("ma1", "m@0-150 a@810-1000"),
        ("zhang1", "r@0-434 a@434-831 h@831-1000"),
        ("biao1", "m@0-150 i@245-456 a@456-715 u@715-1000"),
        ("yi1", "i@0-810"),
    ],
)
def test_shapes_start_where_the_thesis_gives_them(syllable: str, expected: str) -> None:
    found = timed(syllable, 2.0, 3.0, 2.15)
    told = (f"{p.symbol.removeprefix('zh:')}@{1000 * p.start - 2000:.0f}-{1000 * p.end - 2000:.0f}" for p in found)
    assert " ".join(told) == expected


@pytest.mark.parametrize(
    ("figures", "read"),
    [
        ("0", "零"),
        ("10", "十"),
        ("11", "十一"),
        ("105", "一百零五"),
        ("110", "一百一十"),
        ("2021", "二千零二十一"),
        ("10001", "一万零一"),
        ("100010000", "一亿零一万"),
        ("10200000305", "一百零二亿零三百零五"),
        ("1,000.5", "一千点五"),
        ("007", "零零七"),
        ("12345678901234567", "一二三四五六七八九零一二三四五六七"),
    ],
)
def test_numbers(figures: str, read: str) -> None:
    assert chinese(figures) == read


def test_years_are_read_figure_by_figure() -> None:
    assert chinese("2021", year=True) == "二零二一"


def test_simplified_and_traditional_voices_are_one() -> None:
    told = [syllables(Say("长城", Voice(language))) for language in ("cmn", "zh", "zh-TW")]
    assert len(set(told)) == 1
