"""`facescript new`: a name to a starter script beside which everything else is easy."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from facescript.backends.output import write_whole
from facescript.cli.report import refuse

STARTER = """\
# {name}.face: build it with `facescript build {name}.face -o {name}.mp4`

film 1280x720, 30fps

face ada = woman, voice en-us female
    life calm

target cup at 20cm -10cm 30cm

scene hello:
    look at camera
    say "[smile 60%]Hello.[/] | Here is my *cup*."
        on "cup": glance cup
    nod
    show smile 70% for 2s
    wait 500ms
"""


def run(options: argparse.Namespace) -> int:
    """Write NAME.face; refuses where a file stands there."""
    path = Path(options.name if options.name.endswith(".face") else f"{options.name}.face")
    if path.exists():
        return refuse("FS908", path=path)
    text = STARTER.format(name=path.stem)
    try:
        write_whole(path, lambda place: place.write_text(text, "utf-8", newline="\n"))
    except OSError as fault:
        return refuse("FS903", path=path, reason=fault.strerror or "it cannot be written")
    print(f"wrote {path}; build it with: facescript build {path} -o {path.with_suffix('.mp4')}", file=sys.stderr)
    return 0
