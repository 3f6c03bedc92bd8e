"""`facescript live`: a script that runs now, answers to events, and goes to whatever listens."""

from __future__ import annotations

import argparse
import asyncio
import os
import sys
import time
from collections.abc import Callable
from contextlib import ExitStack, suppress
from dataclasses import dataclass, replace
from functools import partial
from importlib.util import find_spec
from math import inf
from pathlib import Path
from typing import TYPE_CHECKING, TextIO

from facescript import __version__
from facescript.cli.report import FAULTS, OptionFault, refuse, show
from facescript.cli.settings import port, rate, seconds, settings
from facescript.cli.trials import trial
from facescript.compile import Settings
from facescript.ir.play import Play
from facescript.live.address import AddressFault
from facescript.live.clock import Clock, SimulatedClock, WallClock
from facescript.live.gate import Gate
from facescript.live.hearing.own_voice import OwnVoice
from facescript.live.log import FASTEST, Head, Log, LogFault, Recorded, Replay, open_log
from facescript.live.loop import Keeper, Loop
from facescript.live.onsets import Onsets
from facescript.live.opening import check, fingerprint, open_play, prompter_of, waits
from facescript.live.ports import Ports
from facescript.live.run.run import Run
from facescript.live.show import Show
from facescript.live.sinks.registry import open_sink
from facescript.live.sinks.setting import Setting as Going
from facescript.live.sources.registry import open_source
from facescript.live.sources.setting import Setting as Coming
from facescript.live.talk.conversation import Conversation
from facescript.live.talk.prompting import Prompting
from facescript.project import STANDARD, open_script
from facescript.resolve.told import Prompter
from facescript.speech.model import VoiceBox
from facescript.speech.studio import open_studio
from facescript.world import ReadWorld, WorldFailure

if TYPE_CHECKING:
    from facescript.live.page.page import Page

USUAL = 60.0
"""Frames a second."""

TOKEN = "FACESCRIPT_TOKEN"
"""Where a token may stand that no list of processes shall show."""

FILES = ("csv:", "-")
"""Sinks for which a replay need not take its time."""


@dataclass(frozen=True, slots=True)
class Orders:
    """What the command line says: `seed` and `values` are a log's where one is replayed."""

    options: argparse.Namespace
    fps: float
    seconds: float
    token: str
    chosen: Settings
    recorded: Recorded | None

    @property
    def hasty(self) -> bool:
        """Whether the run need not keep to this machine's clock: a replay into files."""
        files = self.options.page is None and all(sink.startswith(FILES) for sink in self.sinks)
        return self.recorded is not None and files

    @property
    def sinks(self) -> list[str]:
        return list(dict.fromkeys(self.options.to)) or (["-"] if self.options.page is None else [])

    @property
    def port(self) -> int | None:
        """The page's port; None for the usual one. Raises `OptionFault`."""
        return port("--page", self.options.page or None)


def run(options: argparse.Namespace) -> int:
    """Runs until its time is over or it is interrupted. Raises `OptionFault`."""
    orders = _orders(options)
    try:
        source, world = open_script(options.script)
    except WorldFailure as fault:
        return refuse("FS901", name=options.script, reason=fault.args[0])
    read = ReadWorld(world.root)
    play, told = open_play(source, read, orders.chosen)
    voice = open_studio(world, endless=True)
    if play is not None:
        check(play, voice, told)
    code = show(told, hints=False)
    if play is None or code:
        return code or FAULTS
    values, seed = dict(orders.chosen.overrides), play.film.seed
    head = Head(source.name, fingerprint(source, read), seed, orders.fps, __version__, time.time(), values)
    if orders.recorded is not None and orders.recorded.head.sha256 != head.sha256:
        raise OptionFault("FS974", name=options.replay, script=options.script, other=orders.recorded.head.script)
    try:
        with ExitStack() as files:
            prompter = partial(prompter_of, source, read, orders.chosen)
            asyncio.run(_run(orders, play, read, voice, prompter, _keepers(orders, head, files)))
    except AddressFault as fault:
        raise OptionFault(fault.code, **fault.values) from None
    return 0


def _orders(options: argparse.Namespace) -> Orders:
    """Raises `OptionFault`."""
    recorded = _recorded(options)
    if options.script == STANDARD and "stdin:" in options.sources:
        raise OptionFault("FS978", option="--from stdin:", other="`-`, the script on standard input")
    if recorded is not None:
        chosen = Settings(recorded.head.set, {"seed": recorded.head.seed})
        fps = recorded.head.fps
    else:
        chosen = settings(options)
        chosen = replace(chosen, overrides={**trial(options.trials, options.trial), **chosen.overrides})
        fps = _fps(options.fps)
    long = _seconds(options.long)
    return Orders(options, fps, long, options.token or os.environ.get(TOKEN, ""), chosen, recorded)


def _recorded(options: argparse.Namespace) -> Recorded | None:
    """The log that is replayed, from which come the events and how the run is set."""
    if options.replay is None:
        return None
    for option in ("--from", "--set", "--seed", "--fps", "--trials", "--trial"):
        if getattr(options, {"--from": "sources"}.get(option, option[2:])):
            raise OptionFault("FS978", option=option, other="`--replay`, whose log has it")
    if options.log is not None and Path(options.log).resolve() == Path(options.replay).resolve():
        raise OptionFault("FS978", option=f"--log {options.log}", other="the `--replay` of that log: it is still read")
    try:
        return open_log(Path(options.replay))
    except LogFault as fault:
        raise OptionFault("FS973", name=options.replay, reason=fault.args[0]) from None


def _fps(text: str | None) -> float:
    found = USUAL if text is None else rate(text)
    if found > FASTEST:
        raise OptionFault("FS904", option="--fps", value=text, example="60")
    return found


def _seconds(text: str | None) -> float:
    """`2s`, `10min`, or a number of seconds; without end where nothing is said."""
    if text is None:
        return inf
    with suppress(OptionFault):
        return seconds("--for", f"{text}s") or 0.0
    return seconds("--for", text) or 0.0


def _keepers(orders: Orders, head: Head, files: ExitStack) -> list[Keeper]:
    """What is written of the run, into files that are closed with it. Raises `OptionFault`."""
    options, keepers = orders.options, list[Keeper]()
    if options.log is not None:
        keepers.append(Log(_opened(options.log, files), head))
    if options.onsets is not None:
        keepers.append(Onsets(sys.stderr if options.onsets == STANDARD else _opened(options.onsets, files)))
    return keepers


def _opened(name: str, files: ExitStack) -> TextIO:
    try:
        return files.enter_context(Path(name).open("w", encoding="utf-8", newline=""))
    except OSError as fault:
        raise OptionFault("FS903", path=name, reason=fault.strerror or "it cannot be written") from None


async def _run(
    orders: Orders,
    play: Play,
    world: ReadWorld,
    voice: VoiceBox,
    prompter: Callable[[], Prompter],
    keepers: list[Keeper],
) -> None:
    """Raises `AddressFault`."""
    clock: Clock = SimulatedClock() if orders.hasty else WallClock()
    gate = Gate(clock, orders.fps, waits(play), tell)
    feed = gate if orders.recorded is None else Replay(orders.recorded)
    prompting = Prompting(prompter, tuple(face.name for face in play.faces))
    performer, ports = Run(play, voice, orders.fps, prompting), Ports()
    sinks = {address: open_sink(address, Going(orders.token, orders.hasty, tell, ports)) for address in orders.sinks}
    pages = _pages(orders, play, world, performer)
    sinks |= pages
    talk, own = Conversation(prompting, voice, orders.fps), OwnVoice()
    loop = Loop(performer, clock, feed, [*sinks.values(), own, talk], keepers)
    evening = Show(loop, gate, sinks, ports, performer.doubts)
    coming = Coming(play, world, clock, ports, orders.token, tell, evening.status, talk, own)
    sources = {address: open_source(address, coming) for address in dict.fromkeys(orders.options.sources)}
    evening.sources = sources | pages
    try:
        await evening.run(orders.seconds, tell)
    finally:
        await talk.close()
        for line in evening.summary():
            tell(line)


def _pages(orders: Orders, play: Play, world: ReadWorld, run: Run) -> dict[str, Page]:
    """The page, where one is wanted, by the option that wants it. Raises `OptionFault`."""
    if orders.options.page is None:
        return {}
    if find_spec("websockets") is None:
        raise OptionFault("FS960", command="live --page", extra="live")
    from facescript.live.page.page import Page  # it draws

    name = Path(orders.options.script).name
    page = Page(play, name, lambda: run.score, world.read, orders.port, tell)
    return {f"--page {orders.options.page}".strip(): page}


def tell(text: str) -> None:
    """A sentence for who runs it."""
    print(text, file=sys.stderr, flush=True)
