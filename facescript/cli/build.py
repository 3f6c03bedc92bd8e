"""`facescript build`: a script to its outputs, each whole in its place or none at all."""

from __future__ import annotations

import argparse
from dataclasses import replace
from pathlib import Path

from facescript.backends.job import Job, JobFailure
from facescript.backends.numbered import is_numbered
from facescript.backends.output import Outputs, outputs
from facescript.backends.registry import Backend, backends
from facescript.backends.stills import write_pngs
from facescript.cli.captions import fit_captions, font_named
from facescript.cli.losses import losses
from facescript.cli.outputs import no_kind, put, suffix_of, targets
from facescript.cli.pages import page_wish
from facescript.cli.progress import Progress
from facescript.cli.report import FAULTS, OptionFault, refuse, show
from facescript.cli.script import compile_named
from facescript.cli.settings import count, seconds, stretch
from facescript.compile import Compiled
from facescript.project import STANDARD
from facescript.world import World, WorldFailure

PAGE_OPTIONS = ("page", "split")
"""Options that pages alone have."""

OF_ONE_FACE = (".arkit.csv", ".fap")
"""Outputs that are of one face."""

MOST_JOBS = 64
"""Processes that draw at once, whatever is asked for."""


def run(options: argparse.Namespace) -> int:
    """0 made, 1 faults (nothing is written then). Raises `OptionFault`."""
    wanted = [(target, _backend(target, options.kind)) for target in targets(options, ".mp4")]
    _fit(options, wanted)
    try:
        compiled, world = compile_named(options)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    code = show(compiled.diagnostics, hints=False)
    if compiled.score is None or compiled.play is None:
        return code or FAULTS
    progress = Progress(options.quiet)
    return _make(_job(options, compiled, world, progress), wanted, progress)


def _backend(target: str, kind: str | None) -> Backend:
    known = backends()
    suffix = suffix_of(target, kind, known)
    if suffix not in known:
        raise no_kind(target, suffix, known)
    return known[suffix]


def _fit(options: argparse.Namespace, wanted: list[tuple[str, Backend]]) -> None:
    """Options that some output cannot take are an error before any work is done."""
    for target, backend in wanted:
        if options.at is not None and not backend.still:
            raise OptionFault("FS905", option="--at", fitting=".png and .svg", suffix=backend.suffix)
        for option in PAGE_OPTIONS if backend.suffix != ".html" else ():
            if getattr(options, option):
                raise OptionFault("FS905", option=f"--{option}", fitting=".html", suffix=backend.suffix)
        if options.face is not None and backend.suffix not in OF_ONE_FACE:
            raise OptionFault("FS905", option="--face", fitting=" and ".join(OF_ONE_FACE), suffix=backend.suffix)
        if options.split and target == STANDARD:
            raise OptionFault("FS905", option="--split", fitting="named .html", suffix=target)
        if is_numbered(target) and backend.suffix != ".png":
            raise OptionFault("FS905", option="%d", fitting=".png", suffix=backend.suffix)
    fit_captions(options, [backend.suffix for _, backend in wanted])


def _job(options: argparse.Namespace, compiled: Compiled, world: World, progress: Progress) -> Job:
    """The stretch and the manner of the film. Raises `OptionFault` where nothing lies in the stretch."""
    play, score = compiled.play, compiled.score
    assert play is not None and score is not None
    if options.draft:
        film = replace(play.film, width=play.film.width // 4 * 2, height=play.film.height // 4 * 2)
        play, score = replace(play, film=film), replace(score, film=film)
    start, end = stretch(options, score.duration)
    at = _moment(options, score.duration)
    jobs = max(1, count("--jobs", options.jobs, "2")) if options.jobs else 0
    page, font = page_wish(options, world, compiled.source.text), font_named(options.font)
    captions = options.captions or "sentences"
    manner = min(jobs, MOST_JOBS), progress.step, page, captions, font, options.face
    return Job(play, score, world.read, start, end, at, *manner)


def _moment(options: argparse.Namespace, duration: float) -> float | None:
    """What `--at` asks for, in seconds. Raises `OptionFault` where that is not in the film."""
    at = seconds("--at", options.at)
    if at is not None and at > duration:
        raise OptionFault("FS906", asked=f"`--at {options.at}`", duration=duration)
    return at


def _make(job: Job, wanted: list[tuple[str, Backend]], progress: Progress) -> int:
    target = wanted[0][0]
    try:
        show(losses(job, wanted))
        with outputs() as batch:
            for target, backend in wanted:
                with progress.of(target):
                    _write(job, target, backend, batch)
    except JobFailure as fault:
        return refuse("FS907", path=target, reason=fault.args[0])
    except OSError as fault:
        return refuse("FS903", path=target, reason=fault.strerror or "it cannot be written")
    return 0


def _write(job: Job, target: str, backend: Backend, batch: Outputs) -> None:
    write = backend.load()
    if job.page.split:
        from facescript.backends.page.document import write_split

        write_split(job, Path(target), batch)
    elif is_numbered(target):
        write_pngs(job, [batch.place(Path(target % (number + 1))) for number in range(len(job.times()))])
    else:
        put(target, backend.suffix, batch, lambda path: write(job, path))
