"""Whatever a Mandarin line is written in, and what its characters, figures and foreign words are read as."""

from __future__ import annotations

import time

import pytest
from saying import line, over, words_of

from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.lines import Piece, pieces
from facescript.speech.mandarin.phonetic import KNOWN, pinyin, syllables_of
from facescript.speech.mandarin.syllables import numbered, shapes
from facescript.speech.mandarin.units import units
from facescript.speech.model import VoiceFailure


def told(text: str, *readings: tuple[str, str]) -> str:
    """The units of a text: syllables of one joined by `-`, foreign words in brackets, marks as they are sent."""
    asked = line(text, "cmn", *(over(text, part, "reading", read) for part, read in readings))
    found = []
    for piece in pieces(asked):
        assert isinstance(piece, Piece)
        for unit in units(piece, text):
            found.append("-".join(unit.syllables) or (f"[{unit.foreign}]" if unit.foreign else unit.mark.strip()))
    return " ".join(filter(None, found))


@pytest.mark.parametrize(
    ("simplified", "traditional", "expected"),
    [
        ("他长得很高", "他長得很高", "ta1 zhang3 de5 hen3 gao1"),
        ("很长", "很長", "hen3 chang2"),
        ("慢慢地走在地上", "慢慢地走在地上", "man4 man4 de5 zou3 zai4 di4 shang4"),
        ("跑得快", "跑得快", "pao3 de5 kuai4"),
        ("我得走了", "我得走了", "wo3 dei2 zou3 le5"),
        ("得到了", "得到了", "de2 dao4 le5"),
        ("他还书去了", "他還書去了", "ta1 huan2 shu1 qu4 le5"),
        ("他还在", "他還在", "ta1 hai2 zai4"),
        ("一行一行地走过银行", "一行一行地走過銀行", "yi4 hang2 yi4 hang2 de5 zou3 guo4 yin2 hang2"),
        ("第三行", "第三行", "di4 san1 hang2"),
        ("不行", "不行", "bu4 xing2"),
        ("重新写，很重", "重新寫，很重", "chong2 xin1 xie3 , hen3 zhong4"),
        ("三只猫，只是", "三隻貓，只是", "san1 zhi1 mao1 , zhi3 shi4"),
        ("干净的头发", "乾淨的頭髮", "gan1 jing4 de5 tou2 fa5"),
        ("看着，睡着了", "看著，睡著了", "kan4 zhe5 , shui4 zhao2 le5"),
        ("著名的乾隆", "著名的乾隆", "zhu4 ming2 de5 qian2 long2"),
        ("觉得音乐", "覺得音樂", "jue2 de5 yin1 yue4"),
        ("受不了了", "受不了了", "shou4 bu4 liao3 le5"),
        ("玩儿，女儿", "玩兒，女兒", "wan2 er5 , nv3 er2"),
        ("会计开会", "會計開會", "kuai4 ji4 kai1 hui4"),
    ],
)
def test_characters_are_read_in_their_words(simplified: str, traditional: str, expected: str) -> None:
    """What pypinyin errs on most, and the same syllables in both writings."""
    assert told(simplified) == expected
    assert told(traditional) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("一天一个", "yi4 tian1 yi2 ge4"),
        ("第一天，一月，十一岁", "di4 yi1 tian1 , yi1 yue4 , shi2 yi1 sui4"),
        ("统一，唯一的", "tong3 yi1 , wei2 yi1 de5"),
        ("看一看", "kan4 yi5 kan4"),
        ("不是，不好", "bu2 shi4 , bu4 hao3"),
        ("我很好", "wo3 hen2 hao3"),
        ("我想买水果", "wo3 xiang2 mai3 shui2 guo3"),
        ("体检表", "ti2 jian2 biao3"),
        ("你，好", "ni3 , hao3"),
        ("“你”好", "ni2 hao3"),
    ],
)
def test_tones_beside_each_other(text: str, expected: str) -> None:
    assert told(text) == expected


def test_a_reading_that_is_set_keeps_its_tone() -> None:
    assert told("你好", ("你", "ni3")) == "ni3 hao3"
    assert told("长大", ("长大", "ㄔㄤˊ ㄉㄚˋ")) == told("长大", ("长大", "chang2da4")) == "chang2 da4"


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Nǐ hǎo, péngyou men hǎo ma?", "ni2 hao3 , peng2 you5 men5 hao3 ma5 ?"),
        ("ni3 hao3 Zhong1guo2", "ni2 hao3 zhong1 guo2"),
        ("Xī'ān lǜsè nǚ'ér", "xi1 an1 lv4 se4 nv3 er2"),
        ("ni\u030c hǎo", "ni2 hao3"),
        ("ㄋㄧˇ ㄏㄠˇ，ㄓㄨㄥㄍㄨㄛˊ˙ㄇㄚ", "ni2 hao3 , zhong1 guo2 ma5"),
        ("ㄩㄥˋㄒㄩㄢㄦˊㄕˋ", "yong4 xuan1 er2 shi4"),
        ("A4纸，MP3，hello ma", "[A] si4 zhi3 , [MP] san1 , [hello ma]"),
        ("café和Node.js", "[café] he2 [Node.js]"),
        ("Привет世界안녕", "[Привет] shi4 jie4 [안녕]"),
        ("见https://a.b/c?d=1，或me@a.org😀。", "jian4 [https://a.b/c?d=1] , huo4 [me@a.org] ."),
    ],
)
def test_writing_by_sound_and_foreign_words(text: str, expected: str) -> None:
    assert told(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2001年", "er4-ling2-ling2-yi1 nian2"),
        ("2021-03-05", "er4-ling2-er4-yi1-nian2-san1-yue4-wu3-ri4"),
        ("10:30，2:05", "shi2-dian3-san1-shi2-fen1 , liang2-dian3-ling2-wu3-fen1"),
        ("比分3:2", "bi3 fen1 san1-bi3-er4"),
        ("气温-5℃", "qi4 wen1 ling2-xia4-wu3-she4-shi4-du4"),
        ("-3.5%", "fu4-bai3-fen1-zhi1-san1-dian2-wu3"),
        ("1/2，½", "er4-fen1-zhi1-yi1 , er4-fen1-zhi1-yi1"),
        ("第2名2个", "di4 er4 ming2 liang3 ge4"),
        ("2月，12个，1个", "er4 yue4 , shi2-er4 ge4 , yi2 ge4"),
        ("3-5个", "san1-dao4-wu3 ge4"),
        ("101，110米", "yi4-bai3-ling2-yi1 , yi4-bai3-yi1-shi2 mi3"),
        ("￥12，$3万", "shi2-er4-yuan2 , san1-wan4-mei3-yuan2"),
        ("120km/h，5kg大", "yi4-bai3-er4-shi2-gong1-li3-mei2-xiao3-shi2 , wu3-gong1-jin1 da4"),
        ("13812345678", "yao1-san1-ba1-yao1-er4-san1-si4-wu3-liu4-qi1-ba1"),
        ("3+5=8", "san1-jia1-wu2-deng3-yu2-ba1"),
        ("v3.5.1", "[v] san1-dian3-wu2-dian3-yi1"),
        ("③〇二〇年", "san1 ling2 er4 ling2 nian2"),
    ],
)
def test_figures(text: str, expected: str) -> None:
    assert told(text) == expected


def test_every_syllable_of_pinyin_has_its_shapes() -> None:
    assert len(KNOWN) > 400
    assert all(shapes(numbered(f"{syllable}1")) for syllable in KNOWN)


@pytest.mark.parametrize("word", ["hello", "Pelé", "naïve", "Ma3b", "B3", "mǎă", "x" * 60, "nǐ" * 30 + "x", "ma3ma"])
def test_what_is_no_pinyin(word: str) -> None:
    assert pinyin(word) is None


@pytest.mark.parametrize("read", ["ㄅㄅ", "ㄋㄧˇㄏ", "˙", "zhang3da", "ㄓㄤˇx", "ㄅㄩㄥ"])
def test_a_reading_that_is_no_syllable(read: str) -> None:
    with pytest.raises(VoiceFailure) as failure:
        syllables_of(read)
    assert failure.value.code == "FS502"


@pytest.mark.parametrize("text", ["他长得很高。", "-1", "1-2=", "a@"])
def test_a_long_line_takes_no_longer_a_character(text: str) -> None:
    text *= 8_000 // len(text)
    start = time.process_time()
    told(text)
    assert time.process_time() - start < 2.0


@pytest.mark.usefixtures("synthesiser")
def test_each_syllable_of_every_writing_is_a_word_with_a_time() -> None:
    spoken = open_voice().speak(line("Nǐ hǎo，ㄓㄨㄥㄍㄨㄛˊ《长城》——“好”，见 www.a.org 😀，10:30，안녕！", "cmn"))
    assert words_of(spoken) == "Nǐ hǎo ㄓㄨㄥ ㄍㄨㄛˊ 长 城 好 见 www.a.org 10:30 안녕"
    starts = [word.start for word in spoken.words]
    assert starts == sorted(set(starts))
