"""The features of sound: tones in their bands, levels, frames, every rate, silence and its end."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from facescript.speech.listen.bands import CENTRES, ENERGY, F0, FAINTEST, bandwidth, bark, features

Samples = NDArray[np.int16]


def tone(hertz: float, rate: int = 16_000, seconds: float = 0.5, height: float = 0.5) -> Samples:
    return np.rint(height * 32_767 * np.sin(2 * np.pi * hertz * np.arange(round(seconds * rate)) / rate)).astype("<i2")


def test_the_scale_is_the_papers() -> None:
    assert np.diff(bark(np.array(CENTRES))) == pytest.approx(1.75, abs=1.2)
    assert bark(1000.0) == pytest.approx(8.51, abs=0.01)
    assert bandwidth(1000.0) == pytest.approx(162.2, abs=0.1)


@pytest.mark.parametrize("band", range(len(CENTRES)))
@pytest.mark.parametrize("rate", [16_000, 22_050, 44_100])
def test_a_tone_is_loudest_in_its_band(band: int, rate: int) -> None:
    found = features(tone(CENTRES[band], rate), rate)[3:-3]
    assert (found[:, :ENERGY].argmax(axis=1) == band).all()


def test_a_frame_is_a_sixtieth_of_a_second_and_the_last_is_filled_up() -> None:
    assert features(tone(440.0, seconds=1.0), 16_000).shape == (60, 14)
    assert len(features(tone(440.0, seconds=0.101), 16_000)) == 7
    assert len(features(np.zeros(0, dtype=np.int16), 16_000)) == 0


def test_energy_is_the_logarithm_of_the_squares() -> None:
    sound = tone(1000.0)
    loud, quiet = features(sound, 16_000), features((sound // 10).astype(np.int16), 16_000)
    frame = sound[2667:2934] / 32_768.0 * np.hamming(267)
    assert loud[10, ENERGY] == pytest.approx(np.log10(np.square(frame).sum()), abs=0.01)
    assert loud[10, ENERGY] - quiet[10, ENERGY] == pytest.approx(2.0, abs=0.02)


def test_every_rate_gives_the_same() -> None:
    tones = (180.0, 700.0, 1900.0, 3300.0)
    low, high = (features(sum(tone(each, rate, height=0.2) for each in tones), rate)[3:-3] for rate in (16_000, 48_000))
    assert low[:, [1, 3, 7, 9, ENERGY]] == pytest.approx(high[:, [1, 3, 7, 9, ENERGY]], abs=0.1)


def test_a_band_beyond_a_sounds_rate_is_silent() -> None:
    noise = np.random.default_rng(1).integers(-9000, 9000, 8_000).astype(np.int16)
    found = features(noise, 8_000)[3:-3]
    assert (found[:, len(CENTRES) - 1] < found[:, 5] - 4.0).all()


def test_the_voices_height_is_heard_and_silence_has_none() -> None:
    sound = sum(tone(120.0 * number, height=0.2 / number) for number in range(1, 9))
    assert features(sound, 16_000)[5:-5, F0] == pytest.approx(120.0, rel=0.02)
    assert features(np.zeros(8_000, dtype=np.int16), 16_000)[:, :F0] == pytest.approx(np.log10(FAINTEST))
    assert not features(np.zeros(8_000, dtype=np.int16), 16_000)[:, F0].any()
