"""How long `--help` takes over bare Python, and what it loads."""

from __future__ import annotations

import statistics
import subprocess
import sys

from _measure import facescript, row, timed

HEAVY = {"lark", "numpy", "pydantic"}


def main() -> None:
    bare = statistics.median(timed([sys.executable, "-c", "pass"], 15))
    full = statistics.median(timed(facescript("--help"), 15))
    row("`facescript --help` over bare Python", f"{(full - bare) * 1000:.0f} ms", "60 ms", full - bare <= 0.060)
    script = "import sys\nfrom facescript.cli.main import main\ntry: main(['--help'])\nexcept SystemExit: pass\n"
    script += f"print(sorted({HEAVY!r} & set(sys.modules)), file=sys.stderr)"
    loaded = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stderr.strip()
    row("what it loads of lark, numpy, pydantic", loaded, "[]", loaded == "[]")


if __name__ == "__main__":
    main()
