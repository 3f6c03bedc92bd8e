"""The size of a minute's SVG beside the thesis's way of writing it (6.3.2): a group of all shapes a frame."""

from __future__ import annotations

import gzip
import io
import tempfile
from pathlib import Path

from _measure import job_of, row
from _scripts import talk

from facescript.backends.job import Job
from facescript.backends.svg.document import write_svg
from facescript.rig.picture import Shape
from facescript.speech.espeak.voicebox import open_voice

RATE = 30
SECONDS = 60


def main() -> None:
    job = job_of(talk(SECONDS, size="1280x720", fps=RATE), open_voice())
    path = Path(tempfile.mkdtemp(prefix="facescript-bench-")) / "minute.svg"
    write_svg(job, path, sound=False)
    ours, theirs = path.stat().st_size, thesis_size(job)
    ratio = theirs / ours
    figure = f"{ours / 1e6:.2f} MB, a {ratio:.1f}th of {theirs / 1e6:.1f} MB"
    row("an SVG of that minute, 1280x720, without sound", figure, "a 30th", ratio >= 30)
    packed = len(gzip.compress(path.read_bytes(), 9)) / SECONDS / 1000
    row("that SVG after gzip", f"{packed:.1f} KB a second", "8 KB", packed <= 8)


def thesis_size(job: Job) -> int:
    """Bytes of the same outlines written as one `<g>` and `<set>` a frame: styles in classes once, 0.1 px."""
    out = io.StringIO()
    shapes = job.stage.shapes
    times = job.times()
    total = sum(len(f"<style>.c{n}{{fill:#aabbcc}}</style>") for n, _ in enumerate(shapes))
    for first in range(0, len(times), 60):
        drawn = job.stage.frames(times[first : first + 60])
        for frame in range(len(drawn.points)):
            out.seek(0)
            out.truncate()
            begin = (first + frame) / RATE
            for number, shape in enumerate(shapes):
                if drawn.opacity[frame, number] > 0:
                    out.write(f'<path class="c{number}" d="{outline(shape, drawn.points[frame])}"/>')
            wrap = '<g visibility="hidden"><set attributeName="visibility" to="visible" '
            total += out.tell() + len(f'{wrap}begin="{begin:.3f}s" dur="0.033s"/></g>')
    return total


def outline(shape: Shape, points: object) -> str:
    """Absolute cubics with one decimal."""
    text = []
    for contour in shape.contours:
        part = points[contour.first : contour.first + contour.count]  # type: ignore[index]
        numbers = [f"{value:.1f}".removesuffix(".0") for value in part.ravel().tolist()]
        text.append("M" + " ".join(numbers[:2]) + "C" + " ".join(numbers[2:]) + "Z")
    return "".join(text)


if __name__ == "__main__":
    main()
