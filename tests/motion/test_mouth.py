"""The mouth over time: closures that close, at most two shapes, no corner, no state, in step with the sound."""

from __future__ import annotations

from dataclasses import replace
from importlib.util import find_spec
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from facescript.ir.acts import Say, Voice
from facescript.motion.mouth import FALL, RISE, MouthTrack
from facescript.performance.channels import MOUTH
from facescript.schedule.score import TimedLine
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.model import PhoneTime, Spoken
from facescript.speech.mouth.mouthing import DECAY
from facescript.speech.mouth.visemes import SHAPES
from facescript.text import Source, Span

Floats = NDArray[np.float64]
HERE = Span(Source("made.face", ""), 0, 0)
OPEN, WIDE, ROUND, JAW = (MOUTH.index(name) for name in ("open", "wide", "round", "jaw"))

SPEAKS = pytest.mark.skipif(find_spec("espeakng_loader") is None, reason="the package espeakng-loader is not installed")

TEXTS = {
    "en-us": (
        "The baby bumped my big map, and Pam mumbled: maybe.",
        "The city council has voted to close the old harbour bridge.",
        "My baby plays with apples and bananas all day.",
    ),
    "de": ("Mama kauft Äpfel, Bananen und Pampelmusen am Bahnhof.", "Der Stadtrat will die alte Brücke schließen."),
    "es": ("Mi mamá compra papas en la bodega de Pablo.", "El ayuntamiento ha votado cerrar el viejo puente."),
}


def line(spoken: Spoken, start: float = 1.0, cut: float | None = None) -> TimedLine:
    return TimedLine("ada", start, spoken, 1.0, HERE, cut=cut)


def made(symbols: str, length: float = 0.1, start: float = 1.0, cut: float | None = None) -> TimedLine:
    """A line of phones of one length; `_` is silence."""
    phones = [PhoneTime(s.strip("_"), at * length, (at + 1) * length, True) for at, s in enumerate(symbols.split())]
    return line(Spoken(b"", 22_050, len(phones) * length, (), tuple(phones)), start, cut)


def spoken_line(text: str, language: str, rate: float = 1.0) -> TimedLine:
    return line(open_voice().speak(Say(text, Voice(language, rate=rate))))


def channel(track: MouthTrack, index: int, *times: float) -> list[float]:
    return track.sample(np.array(times))[0][:, index].tolist()


@SPEAKS
@pytest.mark.parametrize("rate", [0.6, 0.8, 1.0, 1.3, 1.6])
@pytest.mark.parametrize("language", TEXTS)
def test_lips_are_shut_for_p_b_and_m(language: str, rate: float) -> None:
    """Bar L3; lips are shut 45 ms before a burst and all through an m."""
    seen = 0
    for text in TEXTS[language]:
        timed = spoken_line(text, language, rate)
        track = MouthTrack((timed,))
        for phone in timed.spoken.phones:
            if phone.symbol[:1] in ("p", "b", "m"):
                span = (phone.start, phone.end) if phone.symbol[0] == "m" else (phone.start - 0.045, phone.start)
                gap = track.sample(timed.start + np.linspace(*span, 50)[1:-1])[0][:, OPEN]
                assert np.all(gap == 0), (text, phone)
                seen += 1
    assert seen >= 8


@SPEAKS
@pytest.mark.parametrize("rate", [0.6, 1.0, 1.6])
def test_lips_are_shut_before_a_mandarin_b_p_or_m_parts_them(rate: float) -> None:
    timed = spoken_line("爸爸妈妈买苹果，跑步把包放在北边。", "cmn", rate)
    track = MouthTrack((timed,))
    closures = [phone for phone in timed.spoken.phones if phone.symbol == "zh:m"]
    assert len(closures) == 12
    for phone in closures:
        gap = track.sample(timed.start + np.linspace(phone.end - 0.045, phone.end, 50)[1:-1])[0][:, OPEN]
        assert np.all(gap == 0), phone


@SPEAKS
@pytest.mark.parametrize("rate", [0.6, 1.0, 1.6])
def test_vowels_between_closures_open(rate: float) -> None:
    timed = spoken_line("Papa, Mama, baby, Bob.", "en-us", rate)
    track = MouthTrack((timed,))
    for phone in timed.spoken.phones:
        if phone.symbol[:1] in tuple("ɑaeɛɔoiɪ") and phone.stress:
            times = timed.start + np.linspace(phone.start, phone.end, 60)
            assert track.sample(times)[0][:, OPEN].max() > 0.1, phone


@SPEAKS
@pytest.mark.parametrize("language", [*TEXTS, "cmn"])
def test_mouth_and_sound_are_in_step(language: str) -> None:
    """Bar L1: over whole lines the opening fits the sound's loudness best at -15 to 45 ms of sound behind mouth."""
    texts = TEXTS.get(language, ("爸爸妈妈带孩子去公园玩，天气很好。", "市议会投票决定关闭旧桥。"))
    leads = np.arange(-0.15, 0.2, 0.005)
    likeness = np.zeros(len(leads))
    for text in texts:
        timed = spoken_line(text, language)
        track = MouthTrack((timed,))
        times = np.arange(0, timed.spoken.duration, 0.005)
        loud = standard(loudness(timed.spoken, times))
        likeness += [float((standard(track.sample(times + 1.0 - lead)[0][:, OPEN]) * loud).mean()) for lead in leads]
    assert -0.015 <= leads[int(likeness.argmax())] <= 0.045


def loudness(spoken: Spoken, times: Floats) -> Floats:
    power = np.frombuffer(spoken.pcm, "<i2").astype(float) ** 2
    window = np.hanning(661)
    smooth = np.convolve(power, window / window.sum(), "same")
    return np.interp(times, np.arange(len(smooth)) / spoken.rate, smooth) ** 0.25


def standard(values: Floats) -> Floats:
    standardised: Floats = (values - values.mean()) / values.std()
    return standardised


def first_movement(track: MouthTrack) -> float:
    """When the mouth has gone a hundredth of the way to anywhere, in seconds."""
    times = np.arange(0, 2, 0.001)
    moved = np.abs(track.sample(times)[0]).max(axis=1) > 0.01
    return float(times[np.argmax(moved)])


@pytest.mark.parametrize(
    ("symbol", "least", "most"), [("u", 0.13, 0.2), ("w", 0.13, 0.2), ("a", 0.09, 0.2), ("t", 0.06, 0.2)]
)
def test_the_mouth_moves_before_the_first_sound(symbol: str, least: float, most: float) -> None:
    """Bar L2: at the start of an utterance the mouth leads by 60 to 200 ms."""
    assert least <= 1.0 - first_movement(MouthTrack((made(f"{symbol} a", 0.2),))) <= most


def test_lips_part_with_the_burst() -> None:
    """Bar L2: inside speech a consonant's opening leads its sound by -20 to 70 ms."""
    track = MouthTrack((made("a b a"),))
    times = np.arange(1.05, 1.3, 0.001)
    shut = track.sample(times)[0][:, OPEN] < 0.01
    assert -0.02 <= 1.1 - float(times[np.flatnonzero(shut)[-1]]) <= 0.07


def test_the_mouth_is_still_soon_after_the_last_sound() -> None:
    track = MouthTrack((made("a"),))
    assert channel(track, OPEN, 1.1 + DECAY + 1e-6) == [0]
    assert channel(track, OPEN, 1.12)[0] > 0


def test_a_consonant_rounds_before_a_rounded_vowel() -> None:
    rounded, spread = (channel(MouthTrack((made(f"i s {vowel}"),)), ROUND, 1.13)[0] for vowel in ("u", "i"))
    assert rounded > 0.5
    assert spread == 0


def test_lips_round_ahead_through_consonants_and_while_they_are_shut() -> None:
    """From the last spread vowel on, over all consonants between, 80 to 250 ms before the rounded one is there."""
    track = MouthTrack((made("i s t k u"),))
    rounded = np.array(channel(track, ROUND, *np.arange(1.0, 1.45, 0.005)))
    assert np.all(np.diff(rounded) >= -1e-9)
    begins = 1.0 + 0.005 * float(np.argmax(rounded > 0.05 * rounded.max()))
    assert 0.08 <= 1.4 - begins <= 0.25
    shut = MouthTrack((made("i m u"),)).sample(np.array([1.18]))[0][0]
    assert shut[OPEN] == 0 and shut[ROUND] > 0.5


def test_the_jaw_goes_through_what_the_tongue_does_alone() -> None:
    for symbol, passes in (("t", True), ("k", True), ("l", True), ("m", False), ("s", False)):
        track = MouthTrack((made(f"a {symbol} a"),))
        least = min(channel(track, JAW, *np.arange(1.08, 1.2, 0.005)))
        assert (least == pytest.approx(SHAPES["a"][JAW])) == passes, symbol


@SPEAKS
@pytest.mark.parametrize("rate", [0.46, 1.0, 2.57])
def test_the_lip_is_on_the_teeth_for_f_and_v(rate: float) -> None:
    timed = spoken_line("Five brave friends have obviously improved a comfy, puffy, vivid beaver.", "en-us", rate)
    track, middles = MouthTrack((timed,)), []
    for phone in timed.spoken.phones:
        if phone.symbol[:1] in ("f", "v"):
            middles.append(timed.start + (phone.start + phone.end) / 2)
    bitten = track.sample(np.array(middles))[0]
    assert len(middles) >= 10
    assert np.all(bitten[:, OPEN] == 0) and np.all(bitten[:, MOUTH.index("lower")] <= -0.1)
    assert np.all(bitten[:, MOUTH.index("teeth")] >= 0.5)


def test_fast_speech_opens_less() -> None:
    slow, fast = (MouthTrack((made("t a t a t", length),)) for length in (0.1, 0.05))
    tops = [track.sample(np.arange(1.0, 1.6, 0.001))[0][:, OPEN].max() for track in (slow, fast)]
    assert 0.5 < tops[1] / tops[0] < 0.8


def test_loud_lines_open_the_jaw_further() -> None:
    timed = spoken_line("Papa and Mama are far away.", "en-us")
    soft, loud = (MouthTrack((replace(timed, volume=volume),)) for volume in (0.25, 4.0))
    times = np.arange(1.0, timed.end, 0.01)
    low, high = (track.sample(times)[0][:, JAW].max() for track in (soft, loud))
    assert high > 1.5 * low
    assert np.array_equal(soft.sample(times)[0][:, WIDE], loud.sample(times)[0][:, WIDE])


def test_a_shape_is_reached() -> None:
    track = MouthTrack((made("m a f u"),))
    for name, time in (("m", 1.05), ("a", 1.14), ("f", 1.22), ("u", 1.35)):
        columns = [MOUTH.index(part) for part in ("open", "upper", "lower", "teeth", "tongue")]
        assert track.sample(np.array([time]))[0][0][columns] == pytest.approx(np.array(SHAPES[name])[columns])


SYMBOLS = st.sampled_from("_ p b m f t s ʃ a i uː oʊ ə zh:m zh:a zh:i ɹ w".split())
LINES = st.lists(
    st.tuples(st.lists(SYMBOLS, min_size=1, max_size=12), st.floats(0.02, 0.3), st.floats(0, 1)), min_size=1, max_size=3
)


def track_of(rows: list[tuple[list[str], float, float]]) -> tuple[MouthTrack, float]:
    lines, at = [], 0.3
    for symbols, length, pause in rows:
        lines.append(made(" ".join(symbols), length, at))
        at = lines[-1].end + pause
    return MouthTrack(lines), at


@settings(max_examples=50, deadline=None)
@given(LINES)
def test_at_most_two_shapes_weigh(rows: list[tuple[list[str], float, float]]) -> None:
    track, end = track_of(rows)
    times = np.linspace(-0.5, end + 1, 400)
    first, second, share = track.weights(times)
    assert np.all((share >= 0) & (share <= 1))
    assert np.all((second == first + 1) | (share == 0))
    for part in ("jaw", "wide"):
        first, second, share = track.weights(times, part)
        assert np.all((share >= 0) & (share <= 1) & (second >= first))


@settings(max_examples=50, deadline=None)
@given(LINES)
def test_curves_have_no_jump_and_no_corner(rows: list[tuple[list[str], float, float]]) -> None:
    track, end = track_of(rows)
    quick = min(length for _, length, _ in rows) < 0.1  # between two closures there is less time then
    step = 1e-4
    times = np.arange(-0.3, end + 0.5, step)
    mouth, activity = track.sample(times)
    for curves in (mouth, activity[:, np.newaxis]):
        speed = np.diff(curves, axis=0) / step
        assert np.abs(speed).max(initial=0) < 100  # the shortest way, 30 ms, at twice the widest opening
        assert np.abs(np.diff(speed, axis=0)).max(initial=0) < (5 if quick else 2)  # a corner: tens at once
    assert np.all((activity >= 0) & (activity <= 1))


@settings(max_examples=50, deadline=None)
@given(LINES)
def test_any_order_of_times_gives_the_same(rows: list[tuple[list[str], float, float]]) -> None:
    track, end = track_of(rows)
    times = np.linspace(-0.5, end + 1, 200)
    order = np.argsort(np.sin(times * 1e6))
    whole, activity = track.sample(times)
    shuffled, shuffled_activity = track.sample(times[order])
    assert np.array_equal(shuffled, whole[order])
    assert np.array_equal(shuffled_activity, activity[order])
    assert np.array_equal(np.vstack([track.sample(times[i : i + 1])[0] for i in range(0, 200, 37)]), whole[::37])


def test_a_cut_ends_the_movement() -> None:
    whole, cut = MouthTrack((made("a i a i a i"),)), MouthTrack((made("a i a i a i", cut=1.25),))
    assert channel(cut, OPEN, 1.05, 1.15) == channel(whole, OPEN, 1.05, 1.15)
    assert channel(cut, OPEN, 1.25 + DECAY + 0.01, 1.5) == [0, 0]
    assert channel(whole, OPEN, 1.5)[0] > 0
    assert cut.sample(np.array([1.25 + DECAY + FALL + 0.01]))[1][0] == 0


def test_activity_is_whole_while_the_mouth_moves() -> None:
    track = MouthTrack((made("p a"), made("a i", start=5.0)))
    mouth, activity = track.sample(np.arange(0, 7, 0.001))
    moving = np.abs(mouth).sum(axis=1) > 0
    assert np.all(activity[moving] == 1)
    assert activity[0] == activity[3000] == activity[-1] == 0
    assert RISE > 0.1


def test_a_long_pause_inside_a_line_gives_the_mouth_back() -> None:
    track = MouthTrack((made("a _ _ _ _ _ _ _ _ _ _ _ _ a"),))
    assert track.sample(np.array([1.6]))[1][0] == 0
    short = MouthTrack((made("a _ _ _ a"),))
    assert short.sample(np.array([1.25]))[1][0] == 1


def test_silence_at_the_ends_of_a_line_is_rest() -> None:
    bare, quiet = MouthTrack((made("a"),)), MouthTrack((made("_ _ _ _ _ a _ _ _ _ _", start=0.5),))
    times = np.linspace(0.5, 2, 100)
    assert np.allclose(bare.sample(times)[0], quiet.sample(times)[0])


def test_silence_leaves_the_mouth_alone() -> None:
    for lines in ((), (made("_ _"),), (made("a", cut=1.0),)):
        mouth, activity = MouthTrack(lines).sample(np.linspace(0, 3, 50))
        assert not mouth.any()
        assert not activity.any()


def test_shapes_of_a_talk_are_in_order() -> None:
    lines = [made("p a t ʃ u m", start=0.85 * at) for at in range(40)]
    track = MouthTrack(lines)
    assert all(one.off < two.on for one, two in pairwise(track.shapes))
    assert len(track.shapes) > 200
