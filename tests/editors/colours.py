"""Scripts to the scopes that the TextMate grammar gives them, by VS Code's own library, which runs in node.

`make vscode` brings the library. Run `python tests/editors/colours.py` after a change of the grammar that is meant: it
writes the pages in `tokens/` anew, to be looked at before they are committed.
"""

from __future__ import annotations

import json
import shutil
import subprocess
from collections.abc import Iterator, Sequence
from pathlib import Path

ROOT = Path(__file__).parents[2]
CLIENT = ROOT / "editors" / "vscode"
SCRIPTS = (
    *sorted((Path(__file__).parent / "tokens").glob("*.face")),
    *(ROOT / "examples" / name for name in ("conversation.face", "evening.face", "kiosk.face")),
)
ABSENT = not (shutil.which("node") and (CLIENT / "node_modules" / "vscode-textmate").is_dir())
"""Whether node or the library is not here."""

Token = tuple[int, int, list[str]]
"""Start and end in UTF-16 units, and the scopes from the outermost inwards."""


def coloured(paths: Sequence[Path]) -> list[list[list[Token]]]:
    """The tokens of each line of each script."""
    command = ["node", str(CLIENT / "tokens.mjs"), *map(str, paths)]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=True)
    return json.loads(done.stdout)


def page(path: Path, lines: list[list[Token]]) -> str:
    """A page to read: each line of the script, and below it its words with their scopes."""
    rows: list[str] = []
    for line, tokens in zip(path.read_text("utf-8").split("\n"), lines, strict=True):
        rows += [line, *_rows(line, tokens)]
    return "\n".join(rows).rstrip() + "\n"


def _rows(line: str, tokens: list[Token]) -> Iterator[str]:
    units = line.encode("utf-16-le")
    for start, end, scopes in tokens:
        word = units[2 * start : 2 * end].decode("utf-16-le", "replace").strip()
        if word and scopes:
            yield f"        {word:20}  {' '.join(scope.removesuffix('.face') for scope in scopes)}"


def golden(path: Path) -> Path:
    return Path(__file__).parent / "tokens" / f"{path.stem}.tokens"


if __name__ == "__main__":
    for script, found in zip(SCRIPTS, coloured(SCRIPTS), strict=True):
        golden(script).write_text(page(script, found), "utf-8", newline="\n")
