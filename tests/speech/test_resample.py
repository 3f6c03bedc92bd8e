"""Sound at another rate: as loud, as long, at the same time, and nothing in it that was not there."""

from __future__ import annotations

import numpy as np
import pytest

from facescript.speech.sound.resample import resampled, resampled_length

RATIOS = [(16_000, 22_050), (22_050, 44_100), (22_050, 48_000), (44_100, 48_000), (8_000, 22_050), (96_000, 48_000)]
RATIOS += [(12_345, 16_000)]
SECONDS = 0.5


def tone(hertz: float, rate: int, level: float = 20_000.0) -> np.ndarray:
    return level * np.sin(2.0 * np.pi * hertz * np.arange(round(SECONDS * rate)) / rate + 0.3)


def whole(sound: np.ndarray, rate: int, wanted: int) -> np.ndarray:
    samples = np.rint(sound).astype(np.int16)
    return resampled(samples, rate, wanted, 0, resampled_length(len(samples), rate, wanted))


def middle(sound: np.ndarray) -> np.ndarray:
    """Without the first and last fifth, where the sound begins and ends at once."""
    edge = len(sound) // 5
    return sound[edge:-edge].astype(np.float64)


def power(sound: np.ndarray) -> float:
    return float(np.square(sound).mean())


@pytest.mark.parametrize(("rate", "wanted"), RATIOS)
@pytest.mark.parametrize("share", [0.05, 0.43, 0.83])
def test_a_tone_stays_the_tone_it_was(rate: int, wanted: int, share: float) -> None:
    """At its place to a fraction of a sample, with noise, images and aliases at least 80 dB below."""
    hertz = share * min(rate, wanted) / 2.0
    expected = tone(hertz, wanted)
    found = whole(tone(hertz, rate), rate, wanted)
    assert abs(len(found) - len(expected)) <= 1
    expected = expected[: len(found)]
    assert power(middle(found - expected)) < 1e-8 * power(middle(expected)) + 1.0 / 12.0


@pytest.mark.parametrize("share", [1.0, 1.2, 1.7])
def test_what_the_lower_rate_cannot_hold_is_silent(share: float) -> None:
    """What would come back as another tone is 80 dB down."""
    found = whole(tone(24_000 * share, 96_000), 96_000, 48_000)
    assert power(middle(found)) < 1e-8 * power(tone(100, 48_000))


@pytest.mark.parametrize(("rate", "wanted"), RATIOS)
def test_silence_and_constant_sound_stay(rate: int, wanted: int) -> None:
    assert not whole(np.zeros(rate // 10), rate, wanted).any()
    assert middle(whole(np.full(rate // 4, 1000.0), rate, wanted)) == pytest.approx(1000.0, abs=0.01)


def test_a_stretch_is_the_same_as_in_the_whole() -> None:
    sound = np.random.default_rng(5).integers(-30_000, 30_000, 8_000).astype(np.int16)
    full = resampled(sound, 16_000, 22_050, 0, 11_025)
    for first, last in ((0, 1), (0, 700), (441, 1_323), (10_000, 11_025), (5_000, 5_000)):
        assert np.array_equal(resampled(sound, 16_000, 22_050, first, last), full[first:last])


def test_around_a_sound_there_is_silence() -> None:
    sound = np.full(100, 1000, dtype=np.int16)
    assert not resampled(sound, 16_000, 48_000, -2_000, -1_000).any()
    assert not resampled(sound, 16_000, 48_000, 1_000, 2_000).any()
    assert len(resampled(np.zeros(0, dtype=np.int16), 16_000, 48_000, 0, 50)) == 50
