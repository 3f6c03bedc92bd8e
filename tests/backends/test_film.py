"""Films, looping pictures and stills of whole scripts: what is in the files, the same bytes twice, clean endings."""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence

from facescript.backends import encoder, film, frames, stills
from facescript.backends.encoder import Encoder, program
from facescript.backends.film import write_gif, write_mp4, write_webm
from facescript.backends.frames import CHUNK, film_planes, pictures, planes
from facescript.backends.job import Job, JobFailure
from facescript.canvas.box import Box
from facescript.canvas.planes import Planes
from facescript.canvas.video import video_pixels
from facescript.compile import compile_source
from facescript.schedule.score import TimedLine
from facescript.speech.estimate import EstimatedVoice
from facescript.speech.model import Spoken
from facescript.speech.sound.mix import Soundtrack
from facescript.text import Source, Span
from facescript.world import World

SCRIPT = """\
film 97x54, 20fps, seed 3
background #dfe8f2
face ada = woman
    life conversation
show smile over 300ms
nod
background #336699 over 400ms
look left 20deg for 1s
"""


def job_of(text: str, folder: Path, length: float = 1.9) -> Job:
    world = World(folder)
    compiled = compile_source(Source("test.face", text), world, EstimatedVoice())
    assert compiled.play is not None, compiled.diagnostics.items
    assert compiled.score is not None, compiled.diagnostics.items
    return Job(compiled.play, compiled.score, world.read, 0.0, min(length, compiled.score.duration))


@pytest.fixture(scope="module")
def job(tmp_path_factory: pytest.TempPathFactory) -> Job:
    return job_of(SCRIPT, tmp_path_factory.mktemp("project"))


@pytest.fixture(scope="module")
def speaking(job: Job) -> Job:
    """The same with a sound: a tone."""
    sounding = replace(job)
    tone = (8000 * np.sin(np.arange(round(job.score.duration * 22050)) * 0.1)).astype("<i2")
    spoken = Spoken(tone.tobytes(), 22050, job.score.duration, (), ())
    line = TimedLine("ada", 0.0, spoken, 1.0, Span(Source("", ""), 0, 0))
    sounding.__dict__["sound"] = Soundtrack((line,), 22050, 0, len(tone))
    return sounding


def probed(path: Path) -> str:
    """What ffmpeg says of a file."""
    return subprocess.run([program(), "-hide_banner", "-i", str(path)], capture_output=True, text=True).stderr


def seconds(probe: str) -> float:
    found = re.search(r"Duration: (\d+):(\d+):([\d.]+)", probe)
    assert found, probe
    return int(found[1]) * 3600 + int(found[2]) * 60 + float(found[3])


def children() -> set[str]:
    """The processes started by this one that still run or wait."""
    return set(Path(f"/proc/self/task/{os.getpid()}/children").read_text().split())


def test_mp4_has_h264_and_aac_for_the_whole_time(speaking: Job, tmp_path: Path) -> None:
    told: list[tuple[int, int]] = []
    write_mp4(replace_progress(speaking, told), tmp_path / "film.mp4")
    probe = probed(tmp_path / "film.mp4")
    assert re.search(r"Video: h264.*yuv420p\(tv, bt709, progressive\), 98x54.* 20 fps", probe), probe
    assert "Audio: aac" in probe
    assert seconds(probe) == pytest.approx(1.9, abs=0.06)
    assert told == [(number, 38) for number in range(1, 39)]


def replace_progress(job: Job, told: list[tuple[int, int]]) -> Job:
    other = replace(job, progress=lambda done, total: told.append((done, total)))
    other.__dict__["sound"] = job.sound
    return other


def test_webm_has_vp9_and_opus(speaking: Job, tmp_path: Path) -> None:
    write_webm(speaking, tmp_path / "film.webm")
    probe = probed(tmp_path / "film.webm")
    assert "Video: vp9" in probe
    assert "Audio: opus" in probe
    assert seconds(probe) == pytest.approx(1.9, abs=0.06)


def test_a_film_in_which_nobody_speaks_has_no_sound(job: Job, tmp_path: Path) -> None:
    write_mp4(job, tmp_path / "film.mp4")
    assert "Audio" not in probed(tmp_path / "film.mp4")


def test_gif_loops_for_ever_with_every_frame(job: Job, tmp_path: Path) -> None:
    write_gif(job, tmp_path / "film.gif")
    with Image.open(tmp_path / "film.gif") as picture:
        assert picture.size == (97, 54)
        assert picture.info["loop"] == 0
        assert picture.n_frames >= 30
    assert seconds(probed(tmp_path / "film.gif")) == pytest.approx(1.9, abs=0.06)


def test_a_gif_is_no_swifter_than_players_show(tmp_path: Path) -> None:
    swift = job_of(SCRIPT.replace("20fps", "60fps"), tmp_path, 0.5)
    write_gif(swift, tmp_path / "film.gif")
    with Image.open(tmp_path / "film.gif") as picture:
        durations = [frame.info["duration"] for frame in ImageSequence.Iterator(picture)]
    assert min(durations) >= 20
    assert sum(durations) == pytest.approx(500, abs=40)


@pytest.mark.parametrize("write", [write_mp4, write_webm, write_gif], ids=["mp4", "webm", "gif"])
def test_the_same_job_gives_the_same_bytes(write: object, speaking: Job, tmp_path: Path) -> None:
    write(speaking, tmp_path / "one")  # type: ignore[operator]
    write(speaking, tmp_path / "two")  # type: ignore[operator]
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()


@pytest.mark.parametrize("shared", [frames.SHARED, 3 * 98 * 54 * 3 // 2 * 5, 0], ids=["chunks", "five", "one"])
def test_frames_are_the_same_however_many_processes_draw_them_and_how_far_ahead(
    shared: int, job: Job, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(frames, "SHARED", shared)
    times = np.arange(3 * CHUNK + 5) / 40
    alone = [frame.tobytes() for frame in planes(job.stage, times)]
    with film_planes(job.stage, times, 3) as drawn:
        for frame, expected in zip(drawn, alone, strict=True):
            time.sleep(0.002)  # long enough for the next to be drawn over it, were its slot not kept
            assert frame.tobytes() == expected


def test_a_film_is_what_its_frames_are(job: Job, tmp_path: Path) -> None:
    write_mp4(job, tmp_path / "film.mp4")
    words = [program(), "-loglevel", "error", "-i", str(tmp_path / "film.mp4"), "-f", "rawvideo", "-"]
    decoded = np.frombuffer(subprocess.run(words, capture_output=True, check=True).stdout, np.uint8)
    drawn = np.stack([frame.copy() for frame in planes(job.stage, job.times())])
    difference = decoded.reshape(drawn.shape).astype(int) - drawn
    assert np.abs(difference).mean() < 2.0


def test_a_film_can_be_sought_every_ten_seconds(tmp_path: Path) -> None:
    long = job_of(SCRIPT.replace("20fps", "10fps") + "wait 20s\n", tmp_path, 21.0)
    write_mp4(long, tmp_path / "film.mp4")
    words = [program(), "-skip_frame", "nokey", "-i", str(tmp_path / "film.mp4"), "-vf", "showinfo", "-f", "null", "-"]
    told = subprocess.run(words, capture_output=True, text=True, check=True).stderr
    keys = [float(found) for found in re.findall(r"pts_time:([\d.]+)", told)]
    assert np.diff([*keys, 21.0]).max() <= 10.0


def test_a_films_frame_is_the_picture_of_its_moment(job: Job) -> None:
    times = np.array([0.0, 0.7, 1.4])
    whole = Box(0, 0, 98, 54)
    for frame, picture in zip(planes(job.stage, times), pictures(job.stage, times), strict=True):
        still = Planes(98, 54)
        pixels = np.pad(picture.view("<u4")[..., 0], ((0, 0), (0, 1)), mode="edge")
        still.take(video_pixels(pixels), whole)
        luma = np.s_[: 98 * 54]
        difference = np.abs(frame[luma].reshape(54, 98)[:, :97].astype(int) - still.data[luma].reshape(54, 98)[:, :97])
        assert difference.mean() < 0.4
        assert difference.max() <= 4


def test_png_is_the_moment_asked_for(job: Job, tmp_path: Path) -> None:
    stills.write_png(replace(job, at=1.0), tmp_path / "one.png")
    with Image.open(tmp_path / "one.png") as picture:
        assert picture.size == (97, 54)
        seen = np.asarray(picture)
    (drawn,) = pictures(job.stage, np.array([1.0]))
    assert (seen == drawn[..., 2::-1]).all()


def test_colours_are_those_of_the_script(job: Job, tmp_path: Path) -> None:
    stills.write_png(replace(job, at=0.0), tmp_path / "one.png")
    write_gif(job, tmp_path / "film.gif")
    write_mp4(job, tmp_path / "film.mp4")
    first = [
        program(),
        "-loglevel",
        "error",
        "-i",
        str(tmp_path / "film.mp4"),
        "-frames:v",
        "1",
        str(tmp_path / "mp4.png"),
    ]
    subprocess.run(first, check=True)
    for name in ("one.png", "film.gif", "mp4.png"):
        with Image.open(tmp_path / name) as picture:
            assert picture.convert("RGB").getpixel((2, 2)) == pytest.approx((0xDF, 0xE8, 0xF2), abs=5), name


def test_numbered_pngs_are_the_frames_in_their_order(job: Job, tmp_path: Path) -> None:
    paths = [tmp_path / f"{number}.png" for number in range(5)]
    stills.write_pngs(job, paths)
    for path, frame in zip(paths, pictures(job.stage, job.times()[:5]), strict=True):
        assert (np.asarray(Image.open(path)) == frame[..., 2::-1]).all()


def test_a_broken_picture_is_a_failure_with_its_name(tmp_path: Path) -> None:
    before = children()
    Image.new("RGB", (8, 8)).save(tmp_path / "sky.png")
    bad = job_of('background "sky.png"\nnod\n', tmp_path, 0.2)
    (tmp_path / "sky.png").write_bytes(b"a picture no more")
    for jobs in (1, 2):
        with pytest.raises(JobFailure, match=r"`sky\.png` cannot be used"):
            write_mp4(replace(bad, jobs=jobs, end=CHUNK * 2 / 30), tmp_path / "film.mp4")
    assert children() == before


def test_a_file_that_cannot_be_written_is_a_failure(job: Job, tmp_path: Path) -> None:
    before = children()
    with pytest.raises(JobFailure, match="ffmpeg stopped"):
        write_mp4(job, tmp_path / "missing" / "film.mp4")
    assert children() == before


@pytest.mark.skipif(not Path("/dev/full").exists(), reason="needs a device that is always full")
def test_a_full_disk_is_a_failure(job: Job) -> None:
    with pytest.raises(JobFailure, match="No space left on device"):
        write_webm(job, Path("/dev/full"))


def test_ffmpeg_killed_while_it_works_is_a_failure(tmp_path: Path) -> None:
    before = children()

    def feed() -> None:
        with Encoder((*film.raw_input("yuv420p", 320, 180, 30), *film.MP4), tmp_path / "film.mp4") as running:
            (process,) = children() - before
            os.kill(int(process), signal.SIGKILL)
            for _ in range(10_000):
                running.write(np.zeros(320 * 180 * 3 // 2, dtype=np.uint8))

    with pytest.raises(JobFailure, match="ffmpeg stopped"):
        feed()
    assert children() == before


def test_an_interrupt_while_ffmpeg_takes_no_more_ends_it(tmp_path: Path) -> None:
    before = children(), threading.active_count()

    def feed() -> None:
        with Encoder((*film.raw_input("yuv420p", 320, 180, 30), *film.MP4), tmp_path / "film.mp4") as running:
            (process,) = children() - before[0]
            os.kill(int(process), signal.SIGSTOP)
            for _ in range(10_000):
                running.write(np.zeros(320 * 180 * 3 // 2, dtype=np.uint8))

    usual = signal.signal(signal.SIGINT, signal.default_int_handler)  # ignored in what a shell runs behind
    alarm = threading.Timer(0.5, signal.pthread_kill, (threading.get_ident(), signal.SIGINT))
    alarm.start()
    with pytest.raises(KeyboardInterrupt):
        feed()
    alarm.join()
    signal.signal(signal.SIGINT, usual)
    assert (children(), threading.active_count()) == before


def test_an_interrupt_ends_everything(job: Job, tmp_path: Path) -> None:
    def interrupt(done: int, total: int) -> None:
        if done == 20:
            raise KeyboardInterrupt

    before = children(), threading.active_count()
    with pytest.raises(KeyboardInterrupt):
        write_mp4(replace(job, jobs=2, progress=interrupt), tmp_path / "film.mp4")
    assert (children(), threading.active_count()) == before


def test_nothing_is_left_when_the_program_is_killed(tmp_path: Path) -> None:
    """A build killed outright: ffmpeg and the drawing processes end by themselves."""
    program_text = f"""
import sys
sys.path.insert(0, {str(Path(__file__).parent)!r})
from dataclasses import replace
from pathlib import Path
from test_film import SCRIPT, job_of, write_mp4
job = replace(job_of(SCRIPT, Path({str(tmp_path)!r})), jobs=2, progress=lambda done, total: print(done, flush=True))
write_mp4(job, Path({str(tmp_path)!r}) / "killed.mp4")
"""
    running = subprocess.Popen([sys.executable, "-c", program_text], stdout=subprocess.PIPE)
    assert running.stdout is not None
    running.stdout.readline()
    family = Path(f"/proc/{running.pid}/task/{running.pid}/children").read_text().split()
    assert len(family) == 3
    running.kill()
    running.wait()
    deadline = time.monotonic() + 10
    while (alive := [pid for pid in family if _runs(pid)]) and time.monotonic() < deadline:
        time.sleep(0.02)
    assert not alive


def _runs(pid: str) -> bool:
    try:
        return Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()[0] != "Z"
    except OSError:
        return False


def test_without_ffmpeg_the_reason_is_told(job: Job, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(encoder.imageio_ffmpeg, "get_ffmpeg_exe", lambda: "/nowhere/ffmpeg")
    with pytest.raises(JobFailure, match="ffmpeg cannot be run"):
        write_mp4(job, tmp_path / "film.mp4")
