"""Which suffix is made by which function: the outputs of this version, and those that plug-ins bring."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import entry_points
from pathlib import Path
from typing import TYPE_CHECKING, cast

if TYPE_CHECKING:
    from facescript.backends.job import Job

GROUP = "facescript.backends"
"""Entry points of this group add outputs: name = suffix without its dot, value = `module:function(job, path)`."""


@dataclass(frozen=True, slots=True)
class Backend:
    """An output: its suffix, where its function is, one line of help, whether it can make one moment, and whether
    it is a picture that cannot be transparent."""

    suffix: str
    target: str
    help: str
    still: bool = False
    opaque: bool = False

    def load(self) -> Callable[[Job, Path], None]:
        """Its function. Raises `JobFailure` where a plug-in names what is not there."""
        module, _, function = self.target.partition(":")
        try:
            return cast("Callable[[Job, Path], None]", getattr(import_module(module), function))
        except (ImportError, AttributeError) as fault:
            from facescript.backends.job import JobFailure

            raise JobFailure(f"`{self.target}` cannot be loaded: {fault}") from fault


BACKENDS = (
    Backend(
        ".svg", "facescript.backends.svg.document:write_svg", "animated picture with sound, plays in any browser", True
    ),
    Backend(".html", "facescript.backends.page.document:write_html", "page with a player, its words and the sound"),
    Backend(".mp4", "facescript.backends.film:write_mp4", "film, H.264 and AAC", opaque=True),
    Backend(".webm", "facescript.backends.film:write_webm", "film, VP9 and Opus"),
    Backend(".gif", "facescript.backends.film:write_gif", "looping picture without sound"),
    Backend(".png", "facescript.backends.stills:write_png", "one moment (--at), or a numbered picture a frame", True),
    Backend(".csv", "facescript.backends.tables:write_csv", "table: time and every channel"),
    Backend(".jsonl", "facescript.backends.tables:write_jsonl", "lines of JSON: time and every channel"),
    Backend(".arkit.csv", "facescript.backends.arkit:write_arkit", "table: a face in the shapes of ARKit"),
    Backend(".fap", "facescript.backends.fap:write_fap", "a face in the animation parameters of MPEG-4"),
    Backend(".wav", "facescript.backends.wav:write_wav", "the sound alone"),
    Backend(".vtt", "facescript.backends.captions.writing:write_vtt", "captions, WebVTT (--captions words: by words)"),
    Backend(".srt", "facescript.backends.captions.writing:write_srt", "captions, SRT (--captions words: by words)"),
    Backend(".epub", "facescript.backends.epub.document:write_epub", "book with sound and the times of its words"),
    Backend(".json", "facescript.backends.play:write_json", "the resolved play and its solved times"),
)


def backends() -> dict[str, Backend]:
    """All outputs by suffix; a plug-in cannot take the place of one of ours."""
    found = {backend.suffix: backend for backend in BACKENDS}
    for entry in entry_points(group=GROUP):
        found.setdefault(f".{entry.name}", Backend(f".{entry.name}", entry.value, f"from {entry.value}"))
    return found
