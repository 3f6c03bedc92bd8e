"""How long `check` takes, process start included: 200 lines cold, and 10,000 lines with its memory."""

from __future__ import annotations

import statistics

from _measure import facescript, peak_memory, row, script_file, timed
from _scripts import lines_of


def main() -> None:
    small = statistics.median(timed(facescript("check", str(script_file(lines_of(200))))))
    row("`check` of a 200-line script, cold", f"{small * 1000:.0f} ms", "300 ms", small <= 0.3)
    words = facescript("check", str(script_file(lines_of(10_000))))
    runs = sorted(peak_memory(words) for _ in range(3))
    seconds, megabytes = runs[1]
    row("`check` of 10,000 lines", f"{seconds:.2f} s", "3 s", seconds <= 3)
    row("its memory", f"{megabytes:.0f} MB", "400 MB", megabytes <= 400)


if __name__ == "__main__":
    main()
