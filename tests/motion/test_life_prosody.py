"""What the head and brows of a speaker do with the voice: on accents, with F0, at rest else, and drawn in place."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from bars import bar, largest_step
from humming import hum
from performing import HERE, Floats, channels, grid, performed

from facescript.compile import compile_source
from facescript.ir.acts import Life
from facescript.motion.perform import perform
from facescript.performance.channels import NAMES
from facescript.performance.performance import Performance
from facescript.schedule.score import Score, TimedLine
from facescript.speech.espeak.voicebox import open_voice
from facescript.speech.model import Spoken
from facescript.speech.sound.accents import heard
from facescript.speech.sound.prosody import HOP
from facescript.text import Source
from facescript.world import World

HEAD = ("head.yaw", "head.pitch", "head.roll")
FASTEST_STEP, FASTEST_CHANGE = 0.32, 10.0
"""Deg from one millisecond to the next, and deg/s of speed (issue 3, the blending law)."""

HIGHER = {0.5: 5.0, 1.3: 7.0, 2.1: 3.0, 2.9: 6.0}
"""Where a hum of 3.6 s has accents: seconds and semitones."""


def life(**knobs: float) -> Life:
    return Life("calm", tuple(knobs.items()))


def said(spoken: Spoken, start: float, cut: float | None = None) -> TimedLine:
    return TimedLine("ada", start, spoken, 1.0, HERE, cut=cut)


def hummed(*starts: float, higher: dict[float, float] | None = None, text: str = "hum") -> tuple[TimedLine, ...]:
    spoken = hum(3.6, HIGHER if higher is None else higher, text=text)
    return tuple(said(spoken, start) for start in starts)


def drawn(what: Life, lines: tuple[TimedLine, ...], duration: float = 8.0, rate: float = 1000.0) -> dict[str, Floats]:
    return channels(performed(duration=duration, life=what, lines=lines), grid(duration, rate))


def peaks(values: Floats, rate: float) -> Floats:
    """When each stretch above nothing is highest, s."""
    edges = np.flatnonzero(np.diff(np.concatenate([[0], (values > 0.01).astype(int), [0]]))).reshape(-1, 2)
    return np.array([(first + np.argmax(values[first:last])) / rate for first, last in edges])


# ------------------------------------------------------------------------------------------------ nods


def test_small_nods_are_lowest_at_accents() -> None:
    pitch = drawn(life(nods=1.0), hummed(*np.arange(1.0, 41.0, 4.0)), 45.0, 200.0)["head.pitch"]
    talking = np.where(grid(45.0, 200.0) % 4.0 < 0.9, 0.0, pitch)  # without the nods before the ends of lines
    lowest = peaks(-talking, 200.0)
    accents = np.concatenate([start + np.array(list(HIGHER)) for start in np.arange(1.0, 41.0, 4.0)])
    beats = [low for low in lowest if np.abs(accents - low).min() < 0.03]
    assert len(beats) > 15


def test_a_nod_takes_half_a_second_at_most_and_is_deeper_on_a_stronger_accent() -> None:
    depths = []
    for up in (2.5, 9.0):
        lines = hummed(*np.arange(1.0, 81.0, 4.0), higher={1.3: up})
        pitch = drawn(life(nods=1.0), lines, 85.0, 200.0)["head.pitch"]
        nods = [pitch[round(200 * (line.start + 0.9)) : round(200 * (line.start + 1.8))] for line in lines]
        moving = [np.count_nonzero(part) / 200.0 for part in nods if part.min() < -0.1]
        assert min(moving) >= 0.2 and max(moving) <= 0.5
        depths.append(-np.mean([part.min() for part in nods if part.min() < -0.1]))
    assert 0.5 < depths[0] < depths[1] / 1.5 < 2.0


# ------------------------------------------------------------------------------------------------ the head with F0


def test_the_head_goes_with_the_voice_and_is_at_rest_between_lines() -> None:
    lines = hummed(2.0, 9.0)
    still, moving = (drawn(life(sway=size), lines, 15.0, 100.0) for size in (0.0, 1.0))
    silent = drawn(life(sway=1.0), (), 15.0, 100.0)
    assert not any(np.any(still[axis]) for axis in HEAD)
    for axis in HEAD:
        way = moving[axis] - silent[axis]
        assert np.abs(way[:140]).max() < 1e-9 and np.abs(way[640:840]).max() < 1e-9
        assert 0.05 < np.abs(way).max() < 2.0
    rise = moving["head.pitch"] - silent["head.pitch"]
    assert all(rise[round(100 * (2.0 + at))] > rise[round(100 * (2.4 + at))] for at in HIGHER)


def test_nothing_in_it_is_quicker_than_3_hz() -> None:
    lines = hummed(*np.arange(1.0, 29.0, 4.0))
    moving, silent = (drawn(life(sway=1.0), spoken, 32.0, 100.0) for spoken in (lines, ()))
    for axis in HEAD:
        power = np.square(np.abs(np.fft.rfft((moving[axis] - silent[axis]) * np.hanning(3200))))
        quick = np.fft.rfftfreq(3200, 0.01) > 3.0
        assert power[quick].sum() < 0.01 * power.sum()


def test_a_line_that_breaks_off_moves_nothing_after() -> None:
    what = life(sway=1.0, nods=1.0, brows=30.0)
    whole, broken, silent = (
        drawn(what, (*lines, said(hum(1.0, text="more"), 9.0)), 11.0, 100.0)
        for lines in ((said(hum(3.6, HIGHER), 1.0),), (said(hum(3.6, HIGHER), 1.0, cut=2.0),), ())
    )
    for name in ("head.yaw", "brow.inner.left"):
        assert np.abs(whole[name] - silent[name])[280:400].max() > 0.01
    for axis in HEAD:
        assert np.abs(broken[axis] - silent[axis])[280:850].max() < 1e-9


def test_the_head_rests_in_a_long_pause_of_a_line() -> None:
    spoken = hum(6.0, {1.0: 6.0, 5.0: 6.0})
    quiet = np.frombuffer(spoken.pcm, "<i2").copy()
    quiet[round(2.0 * spoken.rate) : round(4.0 * spoken.rate)] = 0
    paused = replace(spoken, sound=quiet.tobytes())
    moving, silent = (drawn(life(sway=1.0), lines, 8.0, 100.0) for lines in ((said(paused, 1.0),), ()))
    for axis in HEAD:
        way = np.abs(moving[axis] - silent[axis])
        assert way[375:425].max() < 1e-9 and min(way[250:350].max(), way[450:550].max()) > 0.001


def test_a_line_without_sound_or_voice_leaves_the_head_alone() -> None:
    empty = replace(hum(3.6), sound=b"")
    silence = replace(hum(3.6), sound=bytes(len(hum(3.6).pcm)))
    for spoken in (empty, silence):
        moving, silent = (drawn(life(sway=1.0), lines, 6.0, 100.0) for lines in ((said(spoken, 1.0),), ()))
        assert all(np.array_equal(moving[axis], silent[axis]) for axis in HEAD)


def test_gaze_stays_on_the_camera_while_the_head_goes_with_the_voice() -> None:
    found = drawn(life(sway=1.0, nods=1.0), hummed(1.0))
    assert np.hypot(found["gaze.yaw"], found["gaze.pitch"]).max() < bar("H7", "mean error")[1]


def test_a_speaking_head_neither_jumps_nor_jolts() -> None:
    found = drawn(life(sway=1.0, nods=1.0), hummed(0.0, 4.0), 9.0)
    for axis in HEAD:
        assert abs(found[axis][0]) < 1e-9, "it sets off from rest, though the line begins at once"
        assert largest_step(found[axis]) < FASTEST_STEP
        assert largest_step(np.diff(found[axis]) * 1000.0) < FASTEST_CHANGE


def test_the_announcer_moves_by_the_thesis_alone() -> None:
    announcer = Life("announcer", (("brows", 8.0), ("sway", 1.0), ("nods", 1.0)))
    with_accents, without = (
        drawn(announcer, hummed(1.0, 6.0, 11.0, higher=higher), 20.0, 60.0) for higher in (HIGHER, {})
    )
    assert all(np.array_equal(with_accents[axis], without[axis]) for axis in (*HEAD, "brow.inner.left"))


# ------------------------------------------------------------------------------------------------ draws


def test_what_is_said_before_does_not_change_what_later_lines_bring() -> None:
    what = life(brows=30.0, nods=1.0, sway=1.0)
    plain = drawn(what, hummed(4.0, text="later"), 12.0, 100.0)
    longer = drawn(what, (*hummed(4.0, text="first"), *hummed(14.0, text="later")), 22.0, 100.0)
    silent = drawn(life(sway=1.0), (), 22.0, 100.0)
    talking = slice(430, 630)  # before the nod ahead of the line's end
    for name in ("brow.inner.left", *HEAD):
        one, other = (each[name] - silent[name][: len(each[name])] for each in (plain, longer))
        assert one[talking] == pytest.approx(other[1000:][talking], abs=0.05)


def test_the_same_line_again_is_not_moved_the_same() -> None:
    again = drawn(life(nods=1.0), hummed(1.0, 6.0, 11.0, 16.0), 22.0, 100.0)["head.pitch"]
    parts = [again[first : first + 300] for first in (100, 600, 1100, 1600)]
    assert any(np.abs(parts[0] - part).max() > 0.2 for part in parts[1:])


def test_a_chunk_is_as_the_whole() -> None:
    performance = performed(duration=12.0, life=life(brows=20.0, nods=1.0, sway=1.0), lines=hummed(1.0, 6.0))
    times = grid(12.0, 60.0)
    whole = performance.sample(times)
    assert np.array_equal(np.concatenate([performance.sample(times[at : at + 7]) for at in range(0, 720, 7)]), whole)


# ------------------------------------------------------------------------------------------------ brows


def test_brow_raises_come_as_often_as_the_knob_says_spoken_or_not() -> None:
    lines = hummed(*np.arange(10.0, 900.0, 12.0))
    for rate in (4.0, 10.0):
        found = peaks(drawn(life(brows=rate), lines, 900.0, 50.0)["brow.inner.left"], 50.0)
        assert len(found) / 15.0 == pytest.approx(rate, rel=0.25)
        spoken = np.mean((found - 10.0) % 12.0 < 3.6)
        assert 0.2 < spoken < 0.6


def test_strong_accents_attract_raises() -> None:
    lines = hummed(*np.arange(1.0, 801.0, 4.0), higher={1.3: 2.6, 2.5: 8.0})
    found = peaks(drawn(life(brows=6.0), lines, 805.0, 50.0)["brow.inner.left"], 50.0)
    weak, strong = (np.count_nonzero(np.abs((found - 1.0) % 4.0 - at + 0.06) < 0.03) for at in (1.3, 2.5))
    assert strong > 3 * weak
    assert weak + strong > 0.9 * len(found)


# ------------------------------------------------------------------------------------------------ voices

SENTENCES = """\
Good evening, and welcome to the programme.
Tonight we look at bridges, boats and the people who build them.
Some of them have worked by the river for forty years.
Others came only last spring, and have already made it their home.
I have lost my cup in the garden.
Where did you put the keys to the old house?
She looked up and saw that nobody was there.
It will rain in the north, and snow on the hills.
We could take the early train, if you are ready by six.
That is the strangest thing I have ever heard.
Do you really believe what they told you yesterday?
My brother bought a small boat and painted it green.
The museum is closed on Mondays, but the park is open.
Nothing in this town is as it was ten years ago.
Please sit down and tell me everything from the beginning.
He turned sharply, and faced the man across the table.
They have promised to send the letter before the end of the week.
What a beautiful morning this is!
I would like a cup of tea, two slices of bread and some honey.
The children ran down the hill and jumped into the lake.
Can anybody tell me how to get to the station from here?
No one expected the team to win the last match of the season.
The doctor said that you should rest for at least three days.
In the middle of the night the telephone rang.
You must never open this door without asking me first.
There are seven bridges across the river, and each has a story.
If the weather holds, we shall reach the summit by noon.
Her voice was so quiet that I could hardly hear it.
The price of bread has gone up again, and so has the rent.
Thank you for listening, and good night.""".split("\n")


def talk(what: str, voice: str, sentences: list[str], folder: Path) -> Score:
    """A face with a life that looks at the camera and says the sentences, with breaks between."""
    pytest.importorskip("espeakng_loader", reason="the package espeakng-loader is not installed")
    says = "".join(f'say "{text}"\nwait 1200ms\n' for text in sentences)
    script = f"film screen none, seed 3\nface ada = woman, voice {voice}\n    life {what}\nlook at camera\n{says}"
    score = compile_source(Source("talk.face", script), World(folder), open_voice()).score
    assert score is not None
    return score


def multiple_r(found: Performance, line: TimedLine) -> float:
    """R between a line's F0, where it is voiced, and the three turns of the head (least squares with a constant)."""
    f0 = heard(line.spoken).prosody.f0
    frames = np.flatnonzero(f0)
    head = found.sample(line.start + frames * HOP)[:, [found.names.index(axis) for axis in HEAD]]
    tones = 12.0 * np.log2(f0[frames])
    causes = np.column_stack([head, np.ones(len(frames))])
    rest = tones - causes @ np.linalg.lstsq(causes, tones, rcond=None)[0]
    return float(np.sqrt(1.0 - rest.var() / tones.var()))


@pytest.mark.parametrize("what", ["calm", "conversation"])
@pytest.mark.parametrize("voice", ["en-us female", "en-gb"])
def test_l5_head_rotation_goes_with_f0(what: str, voice: str, tmp_path: Path) -> None:
    score = talk(what, voice, SENTENCES, tmp_path)
    found = perform(score)
    r = [multiple_r(found, line) for line in score.lines]
    assert len(r) == 30
    assert bar("L5", "mean")[0] <= np.mean(r) <= bar("L5", "mean")[1]


def test_without_sway_and_nods_the_head_does_not_go_with_f0(tmp_path: Path) -> None:
    score = talk("calm, sway 0%, nods 0%, avert 0%", "en-us", SENTENCES[:4], tmp_path)
    assert not np.any(perform(score).sample(grid(score.duration, 30.0))[:, :3])


@pytest.mark.parametrize(
    ("voice", "sentences"),
    [
        ("en-us female", SENTENCES),
        ("es", ["He perdido mi taza en el jardín de la casa vieja.", "Nadie ha venido a la fiesta del pueblo."] * 12),
        ("cmn", ["今天的天气很好，我们去公园走走吧。", "我昨天丢了一个红色的杯子。"] * 12),
    ],
)
def test_l4_brows_are_highest_just_before_the_accented_syllable_is(
    voice: str, sentences: list[str], tmp_path: Path
) -> None:
    """The syllable's peak is here the loudest frame of a stressed phone, or of a Mandarin character."""
    score = talk("conversation, brows 14/min", voice, sentences, tmp_path)
    brow = perform(score).sample(grid(score.duration, 200.0))[:, NAMES.index("brow.inner.left")]
    raised = peaks(brow, 200.0)
    syllables = np.array([time for line in score.lines for time in loudest(line)])
    speaking = [peak for peak in raised if any(line.start - 0.2 <= peak < line.end for line in score.lines)]
    leads = [1000.0 * (syllables - peak)[np.abs(syllables - peak - 0.06).argmin()] for peak in speaking]
    assert len(leads) > 10
    assert bar("L4", "median")[0] <= np.median(leads) <= bar("L4", "median")[1]
    assert np.median(leads) == pytest.approx(60.0, abs=25.0)
    assert np.percentile(leads, 75) - np.percentile(leads, 25) < 80.0


def loudest(line: TimedLine) -> Iterator[float]:
    stressed = [(phone.start, phone.end) for phone in line.spoken.phones if phone.stress]
    energy = heard(line.spoken).prosody.energy
    for start, end in stressed or [(word.start, word.end) for word in line.spoken.words]:
        first = round(start / HOP)
        yield line.start + HOP * (first + int(np.argmax(energy[first : round(end / HOP) + 1])))
