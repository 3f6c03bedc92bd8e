"""A preview that serves a test, as its own process."""

from __future__ import annotations

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

START = """
from pathlib import Path
from facescript.cli.main import program
from facescript.preview import doors
doors.EDITOR = Path({editor!r})
program()
"""


@contextmanager
def served(folder: Path, *words: str, editor: Path | None = None) -> Iterator[str]:
    """The address of `facescript preview` in a folder; `editor` is the bundle that its page has, if any."""
    code = START.format(editor=str(editor or folder / "none.js"))
    command = [sys.executable, "-c", code, "preview", "--port", "0", *words]
    process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=folder)
    try:
        assert process.stdout is not None
        found = re.search(r"http://\S+/", process.stdout.readline())
        assert found is not None
        yield found[0]
    finally:
        process.terminate()
        process.communicate(timeout=20)
