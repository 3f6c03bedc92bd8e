"""The memory of a ten-minute 1080p film, the program's and ffmpeg's, and whether it grows with the film's length."""

from __future__ import annotations

import subprocess
import tempfile
import time
from pathlib import Path

from _measure import facescript, row, script_file
from _scripts import talk

LONG, SHORT = 600, 60
BAR = 500.0
GROWTH = 60.0
"""MB that nine more minutes may add: the spoken lines and their sum, as 16-bit samples; no picture."""

PERIOD = 0.1
"""Seconds between two looks at the processes."""


def main() -> None:
    short, long = film(SHORT), film(LONG)
    own, other = long
    once = f"{short[0]:.0f} and {short[1]:.0f} for one minute"
    figure = f"{own + other:.0f} MB: {own:.0f} MB, and ffmpeg {other:.0f} MB ({once})"
    met = sum(long) <= BAR and sum(long) - sum(short) <= GROWTH
    row("memory of a ten-minute 1080p film", figure, f"{BAR:g} MB, not growing", met)


def film(seconds: int) -> tuple[float, float]:
    """Peak resident MB of the program, and of ffmpeg."""
    script = script_file(talk(seconds))
    with tempfile.TemporaryDirectory(prefix="facescript-bench-") as folder:
        out = Path(folder) / "film.mp4"
        words = facescript("build", str(script), "-o", str(out), "--quiet")
        process = subprocess.Popen(words, stdout=subprocess.DEVNULL)
        own = other = 0.0
        while process.poll() is None:
            own = max(own, resident(process.pid))
            other = max([other, *map(resident, encoders(process.pid))])
            time.sleep(PERIOD)
        assert process.returncode == 0
        assert out.stat().st_size > 0
    return own, other


def encoders(parent: int) -> list[int]:
    try:
        found = Path(f"/proc/{parent}/task/{parent}/children").read_text().split()
        return [int(pid) for pid in found if "ffmpeg" in Path(f"/proc/{pid}/comm").read_text()]
    except OSError:
        return []


def resident(pid: int) -> float:
    """Peak resident MB of a running process so far; 0 where it has ended."""
    try:
        lines = Path(f"/proc/{pid}/status").read_text().splitlines()
    except OSError:
        return 0.0
    return sum(int(line.split()[1]) / 1024 for line in lines if line.startswith("VmHWM"))


if __name__ == "__main__":
    main()
