"""Labels of phones in ARPAbet, X-SAMPA or IPA, told apart as a whole, to IPA."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable, Sequence

from facescript.speech.mandarin.syllables import PREFIX

UNSPOKEN = frozenset(
    "sil sp h# # ## - _ ... <sil> <s> </s> <eps> <p:> <p> [sil] [silence] (.) (..) (...) ++noise++".split()
)
"""What labels call silence, in small letters, that no word is."""

SILENCES = UNSPOKEN | frozenset(
    "spn pau pause silence noise nsn br breath ssil <unk> +spn+ +nsn+ ++breath++ [noise] xxx epi "
    "bcl dcl gcl kcl pcl tcl".split()
)
"""And what no phone is; among them the closures of TIMIT, whose plosives begin at the burst."""

_ARPABET = """
AA ɑ|AE æ|AH ʌ|AH0 ə|AO ɔ|AW aʊ|AX ə|AX-H ə|AXR ɚ|AY aɪ|EH ɛ|ER ɝ|ER0 ɚ|EY eɪ|IH ɪ|IX ɨ|IY i|OW oʊ|OY ɔɪ|UH ʊ|UW u
UX ʉ|B b|CH tʃ|D d|DH ð|DX ɾ|EL l̩|EM m̩|EN n̩|ENG ŋ̩|F f|G ɡ|HH h|HV ɦ|JH dʒ|K k|L l|M m|N n|NG ŋ|NX ɾ̃|P p|Q ʔ
R ɹ|S s|SH ʃ|T t|TH θ|V v|W w|WH ʍ|Y j|Z z|ZH ʒ
"""
ARPABET = dict(row.split(" ") for row in _ARPABET.strip().replace("\n", "|").split("|"))

_XSAMPA = r"""
b_< ɓ|d` ɖ|d_< ɗ|g ɡ|g_< ɠ|h\ ɦ|j\ ʝ|l` ɭ|l\ ɺ|n` ɳ|p\ ɸ|r` ɽ|r\ ɹ|r\` ɻ|s` ʂ|s\ ɕ|t` ʈ|P ʋ|v\ ʋ|x\ ɧ|z` ʐ|z\ ʑ
A ɑ|B β|B\ ʙ|C ç|D ð|E ɛ|F ɱ|G ɣ|G\ ɢ|G\_< ʛ|H ɥ|H\ ʜ|I ɪ|J ɲ|J\ ɟ|J\_< ʄ|K ɬ|K\ ɮ|L ʎ|L\ ʟ|M ɯ|M\ ɰ|N ŋ|N\ ɴ
O ɔ|O\ ʘ|Q ɒ|R ʁ|R\ ʀ|S ʃ|T θ|U ʊ|V ʌ|W ʍ|X χ|X\ ħ|Y ʏ|Z ʒ|@ ə|@` ɚ|@\ ɘ|{ æ|} ʉ|1 ɨ|2 ø|3 ɜ|3\ ɞ|3` ɝ|4 ɾ|5 ɫ
6 ɐ|7 ɤ|8 ɵ|9 œ|& ɶ|? ʔ|?\ ʕ|<\ ʢ|>\ ʡ|: ː|:\ ˑ|" ˈ|% ˌ|= ̩|_= ̩|~ ̃|_~ ̃|_h ʰ|_w ʷ|_j ʲ|' ʲ|_0 ̥|_d ̪|_^ ̯|_} ̚
"""
XSAMPA = dict(row.split(" ") for row in _XSAMPA.strip().replace("\n", "|").split("|"))
_XSAMPA_SIGN = re.compile(
    "|".join(map(re.escape, sorted(XSAMPA, key=len, reverse=True))) + r"|(?P<mark>_.)|(?P<tie>[-.|])|."
)
_XSAMPA_ONLY = re.compile(r"[A-Z0-9@{}&\\:~?=`\"%]")


def is_silence(label: str) -> bool:
    """Whether a label of a phone stands for no sound."""
    return not label.strip() or label.strip().lower() in SILENCES


def is_unspoken(label: str) -> bool:
    """Whether a label of a word stands for none."""
    return not label.strip() or label.strip().lower() in UNSPOKEN


def to_ipa(labels: Sequence[str]) -> tuple[tuple[str, bool], ...]:
    """Each label as IPA without its stress ("" for silence), and whether it is stressed. The alphabet is that which
    all of them together can be written in."""
    read = _reader(label.strip() for label in labels if not is_silence(label))
    return tuple(("", False) if is_silence(label) else _parted(read(label.strip())) for label in labels)


def _reader(labels: Iterable[str]) -> Callable[[str], str]:
    kinds = {label for label in labels if not label.startswith(PREFIX)}
    if kinds and all(_bare(label) in ARPABET for label in kinds):
        return _from_arpabet
    if any(not label.isascii() for label in kinds) or not any(map(_XSAMPA_ONLY.search, kinds)):
        return str
    return from_xsampa


def looks_like_phones(labels: Sequence[str]) -> bool:
    """Whether labels are phones rather than words: ARPAbet, signs that only alphabets of sounds have, or all short."""
    kinds = [label.strip() for label in labels if not is_silence(label)]
    if not kinds:
        return False
    if all(_bare(label) in ARPABET for label in kinds):
        return True
    signs = sum(bool(re.search(r"[@{}&\\:~0-9ɐ-ʯˈˌːθðβŋæøœç]", label)) for label in kinds)
    return max(map(len, kinds)) <= 5 and (signs * 4 >= len(kinds) or sum(map(len, kinds)) < 1.5 * len(kinds))


def _bare(label: str) -> str:
    """An ARPAbet label without its stress: `AH0` in either case."""
    return label.upper().rstrip("012")


def _from_arpabet(label: str) -> str:
    if label.startswith(PREFIX):
        return label
    symbol = ARPABET.get(label.upper()) or ARPABET[_bare(label)]
    return f"ˈ{symbol}" if label[-1] == "1" else symbol


def from_xsampa(label: str) -> str:
    """A label in X-SAMPA as IPA."""
    if label.startswith(PREFIX):
        return label
    return "".join(
        "" if found["mark"] or found["tie"] else XSAMPA.get(found[0], found[0])
        for found in _XSAMPA_SIGN.finditer(label)
    )


def _parted(symbol: str) -> tuple[str, bool]:
    plain = unicodedata.normalize("NFC", symbol.replace("ˈ", "").replace("ˌ", ""))
    return plain, "ˈ" in symbol
