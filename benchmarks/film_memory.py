"""The memory of a ten-minute 1080p film, and whether it grows with the film's length."""

from __future__ import annotations

import tempfile
from pathlib import Path

from _measure import facescript, peak_memory, row, script_file
from _scripts import talk

LONG, SHORT = 600, 60
BAR = 500.0
GROWTH = 60.0
"""MB that ten times the length may add: the sound is held whole."""


def main() -> None:
    sizes = {seconds: film(seconds) for seconds in (SHORT, LONG)}
    figure = f"{sizes[LONG]:.0f} MB ({sizes[SHORT]:.0f} MB for one minute)"
    met = sizes[LONG] <= BAR and sizes[LONG] - sizes[SHORT] <= GROWTH
    row("memory of a ten-minute 1080p film", figure, f"{BAR:g} MB, not growing", met)


def film(seconds: int) -> float:
    """Peak resident MB of the program that makes it; ffmpeg is a process of its own."""
    script = script_file(talk(seconds))
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        out = Path(folder) / "film.mp4"
        _, memory = peak_memory(facescript("build", str(script), "-o", str(out), "--quiet"))
        assert out.stat().st_size > 0
    return memory


if __name__ == "__main__":
    main()
