"""The tables of outputs and of voices to their pages."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from facescript.backends.registry import BACKENDS, Backend
from facescript.speech.model import VoiceFailure
from facescript.speech.voices.registry import ENGINES, Row
from facescript.world import World
from website.page import Page, sentence, table


def pages() -> Iterator[Page]:
    yield Page(
        "reference/outputs.md", "Outputs", OUTPUT_HEAD + table(("suffix", "is", "besides"), map(_output, BACKENDS))
    )
    yield Page("reference/voices.md", "Voices", VOICE_HEAD + "\n".join(_engine(row) for row in ENGINES.values()))


OUTPUT_HEAD = """\
# Outputs

`facescript build SCRIPT -o OUT` makes whatever the suffix says; `-o` may stand several times. The same script gives
the same bytes. [The language](../language.md#19-the-outputs-and-their-channels) says what is in each; packages may
bring others (entry points `facescript.backends`).

"""

VOICE_HEAD = """\
# Voices

Behind `voice` stands a language, then `female`, `male` or a variant's name, or an engine and its voice: `voice
en-us female`, `voice en-us flite "slt"`. [Speech](../speech.md) has the engines. `facescript list voices` lists
what your machine has.

"""


def _output(row: Backend) -> tuple[str, str, str]:
    besides = [*["one moment with `--at`"] * row.still, *["cannot be transparent"] * row.opaque]
    return f"`{row.suffix}`", sentence(row.help), "; ".join(besides)


def _engine(row: Row) -> str:
    """The voices that come with the program; those that each machine has otherwise are not listed."""
    parts = [f"## {row.name} {{#{row.name}}}\n", sentence(row.help) + "\n"]
    if row.name == "espeak":
        try:
            voices = list(row.load()(World(Path())).voices())
        except VoiceFailure:
            voices = []
        parts.append(table(("language", "is"), ((f"`{name}`", told) for name, told in voices)))
    return "\n".join(parts)
