"""A 1080p film made by us beside the same captured from its SVG in Chromium, frame by frame, and encoded alike."""

from __future__ import annotations

import base64
import subprocess
import sys
import tempfile
import time
from dataclasses import replace
from pathlib import Path

from _measure import job_of, row
from _scripts import talk

from facescript.backends.encoder import program as ffmpeg
from facescript.backends.film import write_mp4
from facescript.backends.svg.document import write_svg
from facescript.speech.espeak.voicebox import open_voice

sys.path.insert(0, str(Path(__file__).parents[1] / "tests" / "browser"))
from chromium import Page, program

SECONDS = 5.0
BAR = 3.0
ENCODE = "-f image2pipe -c:v png -r 30 -i - -c:v libx264 -preset veryfast -crf 20 -pix_fmt yuv420p -y".split()


def main() -> None:
    if program() is None:
        print("| a film beside Chromium's capture | no Chromium here | 3 times | not run |")
        return
    job = replace(job_of(talk(60), open_voice()), end=SECONDS)
    count = len(job.times())
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as name:
        folder = Path(name)
        write_svg(job, folder / "film.svg", sound=False)
        theirs = captured(folder / "film.svg", job.times().tolist(), folder / "theirs.mp4")
        start = time.perf_counter()
        write_mp4(replace(job), folder / "ours.mp4")
        ours = time.perf_counter() - start
    figure = f"{theirs / ours:.1f} times ({count / ours:.0f} and {count / theirs:.0f} frames/s)"
    row("a film beside Chromium capturing the SVG", figure, f"{BAR:g} times", theirs / ours >= BAR)


def captured(svg: Path, times: list[float], film: Path) -> float:
    """Seconds to take every frame from the browser and encode it."""
    with Page(svg.as_uri(), 1920, 1080) as page:
        page.run("document.documentElement.pauseAnimations()")
        words = [ffmpeg(), "-loglevel", "error", *ENCODE, str(film)]
        encoder = subprocess.Popen(words, stdin=subprocess.PIPE)
        assert encoder.stdin is not None
        start = time.perf_counter()
        for moment in times:
            page.run(f"document.documentElement.setCurrentTime({moment:.4f})")
            encoder.stdin.write(base64.b64decode(page.call("Page.captureScreenshot", format="png")["data"]))
        encoder.stdin.close()
        assert encoder.wait() == 0
        return time.perf_counter() - start


if __name__ == "__main__":
    main()
