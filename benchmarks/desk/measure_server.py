"""The language server as an editor meets it: how soon it answers, from its start on and once a long script is open."""

from __future__ import annotations

import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from random import Random

from _rough_client import COMMAND, RoughClient
from _scripts import lines_of
from measure_edits import Author, flat, judged
from row import Row

BARE = [sys.executable, "-c", "from pygls.lsp.server import LanguageServer; LanguageServer('bare', '1').start_io()"]
"""A pygls server without features."""

STARTS = 15
ASKED = 300
"""Requests of a kind, at places all over the script."""

METHODS = ("hover", "definition", "completion")

EDITS = ((2_000, 600, 25, 80), (10_000, 300, None, 150))
"""Lines, keys, and the bars of p50 (None: none) and p99 in milliseconds."""


def rows() -> Iterator[Row]:
    yield _start()
    text = lines_of(2_000)
    with tempfile.TemporaryDirectory() as folder:
        client = RoughClient(subprocess.DEVNULL)
        client.begin(Path(folder))
        uri = (Path(folder) / "long.face").as_uri()
        document = {"uri": uri, "languageId": "face", "version": 1, "text": text}
        client.tell("textDocument/didOpen", {"textDocument": document})
        client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
        for method in METHODS:
            yield _answers(client, uri, text, method)
        client.end()
    for lines, keys, half, most in EDITS:
        for name, written in (("scenes", lines_of), ("one flat script", flat)):
            yield _edits(f"an edit in {lines:,} lines of {name}, through the pipe", written(lines), keys, (half, most))


def _start() -> Row:
    """Both kinds of server by turns, so that what else the machine does meets both alike."""
    took: dict[str, list[float]] = {"bare": [], "ours": []}
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(STARTS):
            for name, command in (("bare", BARE), ("ours", COMMAND)):
                start = time.perf_counter()
                client = RoughClient(subprocess.DEVNULL, command)
                client.begin(Path(folder))
                took[name].append(time.perf_counter() - start)
                client.end()
    bare, ours = statistics.median(took["bare"]), statistics.median(took["ours"])
    found = f"{ours / bare:.2f} times ({1000 * ours:.0f} of {1000 * bare:.0f} ms)"
    return Row("server ready, of a pygls server without features", "1.3 times", found, ours <= 1.3 * bare)


def _answers(client: RoughClient, uri: str, text: str, method: str) -> Row:
    """From a request sent to its answer read, whole."""
    lines, chance, took = text.split("\n"), Random(1), []
    for _ in range(ASKED):
        line = chance.randrange(len(lines))
        place = {"line": line, "character": chance.randrange(len(lines[line]) + 1)}
        start = time.perf_counter()
        client.ask(f"textDocument/{method}", {"textDocument": {"uri": uri}, "position": place})
        took.append(1000 * (time.perf_counter() - start))
    took.sort()
    most = took[int(len(took) * 0.99)]
    found = f"p50 {statistics.median(took):.1f} ms, p99 {most:.1f} ms"
    return Row(f"{method} in 2,000 lines", "p99 20 ms", found, most <= 20)


def _edits(what: str, text: str, keys: int, bars: tuple[float | None, float]) -> Row:
    """From a key sent to all that is wrong with the script read, whole."""
    author, took = Author(text), []
    with tempfile.TemporaryDirectory() as folder:
        client = RoughClient(subprocess.DEVNULL)
        client.begin(Path(folder))
        uri = (Path(folder) / "long.face").as_uri()
        client.tell(
            "textDocument/didOpen",
            {"textDocument": {"uri": uri, "languageId": "face", "version": 0, "text": text}},
        )
        client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
        for version in range(1, keys + 1):
            before = author.text
            author.key()
            change = {
                "textDocument": {"uri": uri, "version": version},
                "contentChanges": [_change(before, author.text)],
            }
            start = time.perf_counter()
            client.tell("textDocument/didChange", change)
            client.ask("textDocument/diagnostic", {"textDocument": {"uri": uri}})
            took.append(1000 * (time.perf_counter() - start))
        client.end()
    return judged(what, took, bars)


def _change(before: str, after: str) -> dict[str, object]:
    """What differs in two texts, as an editor says it."""
    first = _shared(before, after)
    rest = _shared(before[first:][::-1], after[first:][::-1])
    start, end = ({"line": before.count("\n", 0, at), "character": at - before.rfind("\n", 0, at) - 1}
                  for at in (first, len(before) - rest))  # fmt: skip
    return {"range": {"start": start, "end": end}, "text": after[first : len(after) - rest]}


def _shared(one: str, other: str) -> int:
    """How many signs two texts begin with alike."""
    least = min(len(one), len(other))
    return next((index for index in range(least) if one[index] != other[index]), least)
