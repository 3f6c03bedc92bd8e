"""Pages and films: picture beside sound, in Chromium and in a film's own frames; a page's size, how soon it is made.

The two announcer scripts beside this file are five minutes long each.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
import time
import wave
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import imageio.v3 as iio
import imageio_ffmpeg
import numpy as np
from numpy.typing import NDArray
from row import Row

from facescript.backends.film import write_mp4
from facescript.backends.job import Job
from facescript.backends.page.document import write_html
from facescript.backends.page.wish import PageWish
from facescript.backends.wav import write_wav
from facescript.compile import compile_source
from facescript.performance.channels import INDEX
from facescript.speech.studio import open_studio
from facescript.text import Source
from facescript.world import World

sys.path.insert(0, str(Path(__file__).parents[2] / "tests" / "browser"))
from chromium import Page, program

HERE = Path(__file__).parent
Floats = NDArray[np.float64]

BAR = "15 ms early, 45 ms late"
EARLY, LATE = -0.015, 0.045
BUILD, FRAMES = 0.1, 0.9
SECONDS = 4.0

PLAYED = ((0.0, 1.0), (71.3, 1.0), (150.2, 1.5), (33.3, 0.5), (202.0, 2.0))
"""Where the page is sought, and the speed it is then played at."""

DRAWN = """
new Promise(done => {
  const audio = document.querySelector("audio"), found = [], start = performance.now();
  const ahead = () => (facescript.drawn - audio.currentTime) / audio.playbackRate;
  const look = () => setTimeout(() => {
    if (!audio.paused && !audio.seeking) found.push(ahead());
    if (performance.now() - start < SECONDS * 1000) return requestAnimationFrame(look);
    facescript.pause();
    done(found);
  });
  audio.playbackRate = RATE; facescript.seek(FROM); facescript.play(); requestAnimationFrame(look);
})
"""
"""Looked at after each frame is drawn: by how much its picture is ahead of the sound."""

RATE = """
new Promise(done => {
  let count = 0; const start = performance.now();
  const look = () => {
    count++;
    performance.now() - start > SECONDS * 1000 ? done(count / SECONDS) : requestAnimationFrame(look);
  };
  requestAnimationFrame(look);
})
"""

HEARD = """
new Promise(async done => {
  const audio = document.querySelector("audio");
  window.tape ||= (() => {
    const context = new AudioContext(), node = context.createScriptProcessor(1024, 1, 1);
    const tape = { context, samples: [] };
    context.createMediaElementSource(audio).connect(node); node.connect(context.destination);
    node.onaudioprocess = (event) => tape.on && tape.samples.push(...event.inputBuffer.getChannelData(0));
    return tape;
  })();
  facescript.pause(); audio.playbackRate = 1;
  await new Promise(sought => { audio.onseeked = sought; audio.currentTime = FROM; });
  await new Promise(quiet => setTimeout(quiet, 300));
  tape.samples = []; tape.on = true; await audio.play();
  setTimeout(() => { facescript.pause(); tape.on = false; done([tape.context.sampleRate, tape.samples]); }, 1500);
})
"""
"""What is really heard after a seek."""


def rows() -> Iterator[Row]:
    if program() is None:
        yield Row("pages in Chromium", BAR, "no Chromium here", None)
        return
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as name:
        folder = Path(name)
        for language, called in (("en", "English"), ("zh", "Mandarin")):
            yield from _page(folder, language, called)
        yield _film(folder)


def _page(folder: Path, language: str, called: str) -> Iterator[Row]:
    """A five-minute announcer's page: made, measured and played."""
    job, path = replace(_job(language), page=PageWish("announcer")), folder / f"{language}.html"
    begun = time.process_time()
    write_html(job, path)
    share, megabytes = (time.process_time() - begun) / job.end, path.stat().st_size / 1e6
    what = f"announcer's page in {called}, {job.end / 60:.1f} minutes"
    yield Row(f"{what}: making it, of its length", f"at most {BUILD}", f"{share:.3f}", share <= BUILD)
    yield Row(f"{what}: its size", "told", f"{megabytes:.1f} MB, {60 * megabytes / job.end:.2f} MB a minute", None)
    sound = _samples(job, folder)
    with Page("data:text/html,<body>", 1280, 720) as page:
        blank = float(page.run(RATE.replace("SECONDS", f"{SECONDS}")))
    with Page(path.as_uri(), 1280, 900) as page:
        page.run("new Promise(done => setTimeout(done, 500))")
        found = np.concatenate([_ahead(page, start, rate) for start, rate in PLAYED])
        yield _sync(f"{what}: picture against the sound's clock in Chromium, {len(found)} frames", found)
        seeks = [_heard_at(page, sound, start) for start in (12.34, 64.1, 111.7, 230.9)]
        yield _sync(f"{what}: sound heard after {len(seeks)} seeks against its clock", np.array(seeks))
        page.run("facescript.seek(20); facescript.play()")
        ours = float(page.run(RATE.replace("SECONDS", f"{SECONDS}")))
        yield Row(
            f"{what}: frames a second in Chromium, played",
            f"{FRAMES} of a blank page",
            f"{ours / blank:.2f} ({ours:.0f} of {blank:.0f})",
            ours >= FRAMES * blank,
        )


def _sync(what: str, ahead: Floats) -> Row:
    """`ahead` is by how many seconds the picture is ahead of the sound."""
    early, late = float(ahead.max()), float(-ahead.min())
    middle = 1000 * float(np.median(np.abs(ahead)))
    found = (
        f"{max(early, 0) * 1000:.1f} ms early, {max(late, 0) * 1000:.1f} ms late at most, {middle:.1f} ms in the median"
    )
    return Row(what, BAR, found, early <= -EARLY and late <= LATE)


def _ahead(page: Page, start: float, rate: float) -> Floats:
    """By how much the picture is ahead of the sound, frame by frame, once it plays steadily."""
    script = DRAWN.replace("SECONDS", f"{SECONDS}").replace("FROM", f"{start}").replace("RATE", f"{rate}")
    return np.array(page.run(script))[5:]


def _heard_at(page: Page, sound: tuple[Floats, int], start: float) -> float:
    """By how many seconds a picture drawn at the sound's clock is ahead of what is really heard after a seek."""
    rate, samples = page.run(HEARD.replace("FROM", f"{start}"))
    heard = np.array(samples)
    heard = heard[int(np.argmax(np.abs(heard) > 0)) :][: rate // 2]
    ours, own = sound
    wanted = np.interp(np.arange(int((start - 0.2) * rate), int((start + 0.8) * rate)) / rate, *_timed(ours, own))
    match = np.correlate(wanted, heard, "valid")
    return 0.2 - int(np.argmax(match)) / rate


def _timed(samples: Floats, rate: int) -> tuple[Floats, Floats]:
    return np.arange(len(samples)) / rate, samples


def _job(language: str) -> Job:
    name = f"announcer_{language}.face"
    world = World(HERE)
    source = Source(name, (HERE / name).read_text("utf-8"))
    compiled = compile_source(source, world, open_studio(world))
    assert compiled.play is not None and compiled.score is not None, [item.message for item in compiled.diagnostics]
    return Job(compiled.play, compiled.score, world.read, 0.0, compiled.score.duration)


def _samples(job: Job, folder: Path) -> tuple[Floats, int]:
    write_wav(job, folder / "sound.wav")
    return _read(folder / "sound.wav")


def _read(path: Path) -> tuple[Floats, int]:
    with wave.open(str(path)) as sound:
        return np.frombuffer(sound.readframes(sound.getnframes()), "<i2").astype(np.float64), sound.getframerate()


# ---------------------------------------------------------------- films

FROM, TO = 30.0, 50.0
LAGS = np.arange(-0.1, 0.1, 0.001)


def _film(folder: Path) -> Row:
    """A film's own frames against its own sound: the lag of the mouth's height in the decoded frames behind the
    performance, and the lag of the decoded sound behind the soundtrack."""
    job = replace(_job("en"), start=FROM, end=TO)
    write_mp4(job, folder / "film.mp4")
    height, width = job.stage.height, job.stage.width
    frames = iio.imread(folder / "film.mp4", plugin="FFMPEG")
    times = np.arange(len(frames)) / job.fps
    mouth = frames[:, height // 2 : height * 3 // 4, width * 4 // 10 : width * 6 // 10].astype(np.float64)
    seen = (mouth[..., 0] < 110).mean(axis=(1, 2))  # the dark of an open mouth
    face = next(face.name for face in job.score.faces if face.seen)
    opened = [job.performance.sample_face(face, FROM + times + lag)[:, INDEX["mouth.open"]] for lag in LAGS]
    picture = -LAGS[np.argmax([np.corrcoef(seen, each)[0, 1] for each in opened])]
    sound = _film_sound(job, folder)
    ahead = sound - picture
    shown = np.array([ahead, ahead - 1 / job.fps])  # a frame is seen until the next comes
    return _sync(f"film at {job.fps:g} frames a second: its frames against its sound", shown)


def _film_sound(job: Job, folder: Path) -> float:
    """By how many seconds the sound decoded from the film is behind the soundtrack."""
    ours, rate = _samples(job, folder)
    words = [imageio_ffmpeg.get_ffmpeg_exe(), "-loglevel", "error", "-y", "-i", str(folder / "film.mp4")]
    subprocess.run([*words, "-ar", str(rate), "-ac", "1", str(folder / "film.wav")], check=True)
    decoded, _ = _read(folder / "film.wav")
    part, reach = decoded[5 * rate : 8 * rate], rate // 10
    match = np.correlate(ours[5 * rate - reach : 8 * rate + reach], part, "valid")
    return (reach - int(np.argmax(match))) / rate
