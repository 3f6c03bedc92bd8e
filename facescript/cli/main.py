"""The command line's words to one command's module; imports nothing heavy, so that help is quick."""

from __future__ import annotations

import argparse
import gc
import os
import signal
import sys
from importlib import import_module
from types import FrameType
from typing import NoReturn

from facescript import __version__
from facescript.cli.arguments import COMMANDS, parser

COLLECT = 100_000
"""New objects between two looks for rubbish: compiling makes many that stay, and looking costs a third of its time."""

AGAIN = 0.01
"""Seconds until an interrupt that was lost comes again."""

INTERRUPTED = 130
"""The exit code of a build that was interrupted."""


def program() -> NoReturn:
    """The installed program: `main`, and then nothing that a late interrupt could disturb."""
    try:
        code = main()
    except KeyboardInterrupt:
        code = INTERRUPTED
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    sys.exit(code)


def main(arguments: list[str] | None = None) -> int:
    """Run one command; returns its exit code: 0 done, 1 faults in the script, 2 cannot run."""
    words = sys.argv[1:] if arguments is None else arguments
    if not words:
        parser(__version__).print_help(sys.stderr)
        return 2
    options = parser(__version__).parse_args(words)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _interrupted)
    sys.unraisablehook = _unraised
    try:
        return _run(options)
    except KeyboardInterrupt:
        print("facescript: interrupted; nothing was written", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        sys.stderr.close()
        return 1


def _run(options: argparse.Namespace) -> int:
    gc.set_threshold(COLLECT)
    module = import_module(f"facescript.cli.{COMMANDS[options.command].module}")
    try:
        code: int = module.run(options)
    except Exception as fault:
        from facescript.cli.report import OptionFault, refuse_option

        if isinstance(fault, OptionFault):
            return refuse_option(fault)
        raise
    return code


class Interrupted(KeyboardInterrupt):
    """An interrupt or a termination. Of the interpreter's own kind it keeps in mind that one passed through generated
    code, and then ends by the signal however well it was caught."""


def _interrupted(number: int, frame: FrameType | None) -> NoReturn:
    """End in order, so that nothing half-written stays."""
    raise Interrupted


def _unraised(seen: sys.UnraisableHookArgs) -> None:
    """An interrupt that fell where the interpreter lets nothing through, as in what it does at a fork, comes again."""
    if not isinstance(seen.exc_value, Interrupted):
        sys.__unraisablehook__(seen)
        return
    import threading

    threading.Timer(AGAIN, os.kill, (os.getpid(), signal.SIGINT)).start()


if __name__ == "__main__":
    program()
