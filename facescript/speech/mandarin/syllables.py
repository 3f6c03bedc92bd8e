"""Mandarin syllables in pinyin to the thesis's mouth shapes (sections 5.2 and 5.3) and their times."""

from __future__ import annotations

import re
import unicodedata

from facescript.speech.model import PhoneTime, VoiceFailure

PREFIX = "zh:"
"""What the symbol of a Mandarin mouth shape begins with: `zh:a`, `zh:h'`."""


def _table(rows: str) -> dict[str, str]:
    """`name: value value` again and again."""
    return {name: " ".join(values.split()) for name, values in re.findall(r"(\w+): ((?:\w+(?!:)\b\s*)+)", rows)}


INITIALS = {
    **dict.fromkeys("bpm", "m"),
    "f": "f",
    **dict.fromkeys("dtnljqx", "h'"),
    **dict.fromkeys("gkh", "h"),
    **dict.fromkeys(("zh", "ch", "sh", "r"), "r"),
    **dict.fromkeys("zcs", "z"),
}
"""Table 5.5, rebuilt: the six mouth shapes of the initials."""

FINALS = _table(
    """
    a: a      o: o      e: h      ê: e      ai: a i   ei: e i   ao: a u   ou: o u   an: a n   en: n     ang: a h
    eng: h    er: h     ong: u h  m: m      n: n      ng: h
    i: i      ia: i a   io: i o   ie: i e   iao: i a u          iu: i o u ian: i e n          in: i n   iang: i a h
    ing: i h  iong: u h
    u: u      ua: u a   uo: u o   uai: u a i          ui: u e i uan: u a n          un: u n   uang: u a h
    ueng: u h v: u      ve: u e   van: u e n          vn: u n
    """
)
"""Table 5.6, rebuilt: the finals as compositions of seven shapes; v is ü; after i and ü the final an is en."""

STARTS = {1: (0.0,), 2: (0.0, 0.8095), 3: (0.0, 0.4337, 0.8312), 4: (0.0, 0.245, 0.4565, 0.7153)}
"""Where in its syllable each of its mouth shapes is given (section 5.3)."""

SINGLE_HOLD = 0.8095
"""A syllable of one shape holds it as long as the first of two."""

SYLLABLE = re.compile(r"(zh|ch|sh|[bpmfdtnlgkhjqxrzcs]?)([aeiouvêmng]+)([1-5])\Z")
WITHOUT_INITIAL = _table(
    """
    yi: i     ya: ia    yo: io    ye: ie    yao: iao  you: iu   yan: ian  yin: in   yang: iang          ying: ing
    yong: iong          yu: v     yue: ve   yuan: van yun: vn   er: er    hm: m     ng: ng    hng: ng
    wu: u     wa: ua    wo: uo    wai: uai  wei: ui   wan: uan  wen: un   wang: uang          weng: ueng
    wong: ueng
    """
)
"""Syllables written without an initial, and their finals."""

TONES = {"\u0304": "1", "\u0301": "2", "\u030c": "3", "\u0300": "4"}


def shapes(syllable: str) -> tuple[str, ...]:
    """The mouth shapes of a syllable such as `zhang3`. Raises `VoiceFailure` (FS502) at what is no syllable."""
    initial, final = _parts(syllable)
    before = INITIALS.get(initial, "")
    after = FINALS[final].split()
    if before == "m" and final == "o":
        after = ["u", "o"]
    if before in ("h'", "h") and after[0] in ("i", "u", "e", "o"):
        before = ""
    if before in ("r", "z") and final == "i":
        after = []
    return (before, *after) if before else tuple(after)


def _parts(syllable: str) -> tuple[str, str]:
    """Initial and final of a syllable, ü written v."""
    base = syllable[:-1]
    if base in WITHOUT_INITIAL and syllable[-1] in "12345":
        return "", WITHOUT_INITIAL[base]
    match = SYLLABLE.match(syllable)
    if match and match[1] in ("j", "q", "x") and match[2].startswith("u"):
        return match[1], "v" + match[2][1:]
    if not match or match[2] not in FINALS:
        raise VoiceFailure(f"`{syllable}` is no syllable of pinyin", "FS502")
    return match[1], match[2]


def timed(syllable: str, start: float, end: float, release: float) -> tuple[PhoneTime, ...]:
    """The mouth shapes of a syllable that sounds from `start` to `end`.

    Each begins where section 5.3 gives it and lasts to the next; the mouth is there at its start and on its way to
    the next from then on. A closed initial (m, f) ends at `release`, the moment its lips part.
    """
    found = shapes(syllable)
    length = end - start
    starts = [start + share * length for share in STARTS[len(found)]]
    ends = [*starts[1:], end if len(found) > 1 else start + SINGLE_HOLD * length]
    if found[0] in ("m", "f"):
        ends[0] = min(max(release, start), ends[0])
    return tuple(PhoneTime(PREFIX + name, a, b) for name, a, b in zip(found, starts, ends, strict=True))


def numbered(syllable: str) -> str:
    """`zhǎng` or `zhang3` as `zhang3`; neutral is 5 (or 0, as some write). Raises `VoiceFailure` (FS502)."""
    apart = unicodedata.normalize("NFD", syllable.lower())
    tone = "".join(TONES[sign] for sign in apart if sign in TONES)
    base = "".join(sign for sign in apart if sign not in TONES).replace("u\u0308", "v").replace("u:", "v")
    base = base.replace("e\u0302", "ê")
    base = base.replace("nue", "nve").replace("lue", "lve")
    if base[-1:] == "0":
        base = base[:-1] + "5"
    if not tone and base[-1:] not in tuple("12345"):
        raise VoiceFailure(f"`{syllable}` needs its tone, 1 to 5 (5 is none): `{syllable}1`", "FS502")
    shapes(base + tone)
    return base + tone
