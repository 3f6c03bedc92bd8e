"""Outputs and what they cannot show of a script to warnings."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from facescript.backends.job import Job
from facescript.backends.registry import Backend
from facescript.diagnostics.catalogue import diagnose
from facescript.diagnostics.model import Diagnostic
from facescript.ir.acts import AddLink, SetPicture

CLEAR_OUTPUTS = "`.webm`, `.gif`, `.png` and `.svg`"

FACES_ALONE = frozenset((".mp4", ".webm", ".gif", ".svg", ".png"))
"""Outputs that show the faces and nothing beside them."""

Wanted = Sequence[tuple[str, Backend]]
"""The outputs asked for, and what makes them."""


def losses(job: Job, wanted: Wanted) -> Iterator[Diagnostic]:
    """Tell of outputs that cannot be transparent, or that have no place beside the faces, where the script asks for
    it."""
    yield from _opaque(job, [target for target, backend in wanted if backend.opaque])
    yield from _alone(job, [target for target, backend in wanted if _shows_faces_alone(job, backend)])


def _opaque(job: Job, targets: Sequence[str]) -> Iterator[Diagnostic]:
    clear = job.stage.clear if targets else None
    if clear is not None:
        yield from (diagnose("FS915", clear.span, path=target, fitting=CLEAR_OUTPUTS) for target in targets)


def _alone(job: Job, targets: Sequence[str]) -> Iterator[Diagnostic]:
    beside = (act.span for act in job.score.acts if isinstance(act.verb, (SetPicture, AddLink)))
    first = next(beside, None)
    if first is not None:
        yield from (diagnose("FS945", first, path=target) for target in targets)


def _shows_faces_alone(job: Job, backend: Backend) -> bool:
    return backend.suffix in FACES_ALONE or (backend.suffix == ".html" and job.page.template != "book")
