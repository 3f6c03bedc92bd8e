"""The words of every command: one row a command, one function that adds its options."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass

SPHINX, VOICE = "pocketsphinx", "voice"
"""The ways to align."""

LISTS = ("faces", "looks", "expressions", "actions", "muscles", "channels", "voices", "backends", "lives", "words")
TEXTS = ("summary", "schema")
"""What `list` prints as one text."""


@dataclass(frozen=True, slots=True)
class Command:
    """A command: its module in this package, its line of help, and what it takes."""

    module: str
    help: str
    options: Callable[[argparse.ArgumentParser], None]


def _script(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("script", metavar="SCRIPT", help="a .face file, a play in .json, or - for standard input")


def _settings(parser: argparse.ArgumentParser) -> None:
    _over(parser)
    parser.add_argument("--seed", metavar="N", help="the seed of all chance")


def _over(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="give a `let` another value")
    parser.add_argument("--events", metavar="FILE", help="a file of `event` lines, added to the script's")


def _build(parser: argparse.ArgumentParser) -> None:
    _script(parser)
    parser.add_argument("-o", "--output", action="append", default=[], metavar="OUT", help="the suffix chooses; repeat")
    parser.add_argument("--as", dest="kind", metavar="KIND", help="the kind where the output is - (svg, csv, ...)")
    _settings(parser)
    parser.add_argument("--size", metavar="WxH", help="the picture's size, 1280x720")
    parser.add_argument("--fps", metavar="N", help="frames a second; for tables, rows a second")
    parser.add_argument("--from", dest="start", metavar="TIME", help="begin there, 2s")
    parser.add_argument("--to", dest="end", metavar="TIME", help="end there, 5s")
    parser.add_argument("--at", metavar="TIME", help="one moment only: a still")
    parser.add_argument("--captions", metavar="HOW", help="words or sentences in .vtt and .srt, burn for films")
    parser.add_argument("--font", metavar="FILE", help="with --captions burn: a font that has their signs")
    parser.add_argument("--face", metavar="NAME", help="for .arkit.csv and .fap: whose face, where there are several")
    parser.add_argument("--jobs", metavar="N", help="how many processes draw")
    templates = "plain, announcer, book, script, or an .html of your own"
    parser.add_argument("--page", metavar="TEMPLATE", help=f"for .html: {templates}")
    parser.add_argument("--split", action="store_true", help="for .html: sound and motion in a folder beside it")
    parser.add_argument("--draft", action="store_true", help="half the size, for a quick look")
    parser.add_argument("--quiet", action="store_true", help="no progress")


def _plot(parser: argparse.ArgumentParser) -> None:
    _script(parser)
    parser.add_argument("-o", "--output", action="append", default=[], metavar="OUT", help=".svg or .png; repeat")
    parser.add_argument("--as", dest="kind", metavar="KIND", help="the kind where the output is - (svg, png)")
    parser.add_argument("--channels", metavar="NAME[,NAME...]", help="only these, head.yaw,lid.left")
    parser.add_argument("--from", dest="start", metavar="TIME", help="begin there, 2s")
    parser.add_argument("--to", dest="end", metavar="TIME", help="end there, 5s")
    parser.add_argument("--size", dest="plot_size", metavar="WxH", help="the plot's size, 1200x900")
    _settings(parser)


def _sheet(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("script", metavar="FACE|SCRIPT", help="a kind of face (woman, man, ...), or a .face file")
    parser.add_argument(
        "-o", "--output", action="append", default=[], metavar="OUT", help=".png, .svg or .html; repeat"
    )
    parser.add_argument("--as", dest="kind", metavar="KIND", help="the kind where the output is - (png, svg, html)")
    parser.add_argument("--face", action="append", default=[], metavar="NAME", help="only this face; repeat")
    parser.add_argument("--cell", metavar="N", help="how wide and high each picture is, in pixels")
    parser.add_argument("--units", action="store_true", help="the units of FACS as well")


def _check(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "scripts", nargs="+", metavar="SCRIPT", help=".face files, plays in .json, or - for standard input"
    )
    parser.add_argument("--json", action="store_true", help="a list of objects instead of text")
    parser.add_argument("--fix", action="store_true", help="make all fixes that are sure, then say what is left")
    _over(parser)


def _explain(parser: argparse.ArgumentParser) -> None:
    _script(parser)
    _settings(parser)
    parser.add_argument("--json", action="store_true", help="the same as objects")
    parser.add_argument("--channel", action="append", default=[], metavar="NAME", help="who owned it at --at; repeat")
    parser.add_argument("--at", action="append", default=[], metavar="TIME", help="with --channel: the moment; repeat")
    parser.add_argument("--face", metavar="NAME", help="with --channel: whose channel, where there are several faces")


def _fmt(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("scripts", nargs="+", metavar="SCRIPT", help=".face files, or - for standard input")
    parser.add_argument("--check", action="store_true", help="change nothing; exit 1 where a file is not in the layout")
    parser.add_argument("-o", "--output", metavar="SCRIPT", help="write there; a play in .json becomes a script so")


def _list(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("what", choices=(*LISTS, *TEXTS), metavar="WHAT", help=f"one of {', '.join((*LISTS, *TEXTS))}")


def _new(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("name", metavar="NAME", help="the new script's name")


def _align(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("recording", metavar="RECORDING", help="a .wav, .flac, .ogg or .mp3 file")
    parser.add_argument("text", metavar="TEXT", help="a text file with what is said in it, or - for standard input")
    parser.add_argument("--language", default="en-us", metavar="CODE", help="as in `facescript list voices`")
    parser.add_argument("--pause", nargs="+", metavar="TIME", help="the pause after the first sentence, or `first`")
    by = f"{SPHINX}, the usual way for English where it is installed, or {VOICE}, the usual one else"
    parser.add_argument("--by", choices=(SPHINX, VOICE), help=by)
    kinds = ".TextGrid, .json, .vtt, .srt, .csv or .tsv; repeat"
    parser.add_argument("-o", "--output", action="append", default=[], metavar="OUT", help=kinds)
    parser.add_argument("--as", dest="kind", metavar="KIND", help="the kind where the output is - (json, csv, ...)")


def _lsp(parser: argparse.ArgumentParser) -> None:
    ways = parser.add_mutually_exclusive_group()
    ways.add_argument("--tcp", type=int, metavar="PORT", help="listen on a port of this machine")
    ways.add_argument("--ws", type=int, metavar="PORT", help="the same over WebSocket")


def _preview(parser: argparse.ArgumentParser) -> None:
    told = "a .face file, a play in .json, or - for standard input; without one a playground opens"
    parser.add_argument("script", metavar="SCRIPT", nargs="?", help=told)
    parser.add_argument("--port", metavar="N", help="the port of this machine, where the page is; else a free one")
    parser.add_argument("--open", action="store_true", help="show the page in the browser")
    parser.add_argument(
        "--editor", action="store_true", help="for editors: the text comes, and edits go, as lines of JSON"
    )


def _live(parser: argparse.ArgumentParser) -> None:
    _script(parser)
    coming = "where events come from, stdin: or ws://127.0.0.1:8080; repeat"
    parser.add_argument("--from", dest="sources", action="append", default=[], metavar="ADDRESS", help=coming)
    going = "where the stream goes, - (lines of JSON) where none is said; repeat"
    parser.add_argument("--to", action="append", default=[], metavar="ADDRESS", help=going)
    shown = "show it as a page that fills a screen, at this port of this machine"
    parser.add_argument("--page", nargs="?", const="", metavar="PORT", help=shown)
    parser.add_argument("--fps", metavar="N", help="frames a second, 60")
    parser.add_argument("--for", dest="long", metavar="TIME", help="end after so long, 10min")
    parser.add_argument("--set", action="append", default=[], metavar="NAME=VALUE", help="give a `let` another value")
    parser.add_argument("--seed", metavar="N", help="the seed of all chance")
    parser.add_argument("--trials", metavar="FILE", help="with --trial: a table with a column for each `let`")
    parser.add_argument("--trial", metavar="N", help="with --trials: take the values of that row")
    parser.add_argument("--log", metavar="FILE", help="write down what is heeded, and when")
    parser.add_argument("--replay", metavar="FILE", help="run again what a log says")
    where = "write down when each act was planned and given, to standard error or a .csv"
    parser.add_argument("--onsets", nargs="?", const="-", metavar="FILE", help=where)
    parser.add_argument("--token", metavar="WORD", help="what those must know who come from other machines")


COMMANDS = {
    "align": Command("align", "find when the words of a text are said in a recording", _align),
    "build": Command("build", "make films, pictures, tables and sound from a script", _build),
    "check": Command("check", "say what is wrong with scripts", _check),
    "explain": Command("explain", "show the solved times: when each act starts, settles and ends", _explain),
    "fmt": Command("fmt", "put scripts into the one layout", _fmt),
    "live": Command("live", "run a script now: events in, sixty frames a second out, to whatever listens", _live),
    "lsp": Command("lsp", "serve editors: faults as they are made, times as they are solved", _lsp),
    "list": Command("list", "list what there is: faces, expressions, voices, ...", _list),
    "new": Command("new", "write a starter script", _new),
    "plot": Command("plot", "draw what is done when, over the curves of what moves", _plot),
    "preview": Command(
        "preview", "show a script as a page that follows each save: the face, and its timeline", _preview
    ),
    "sheet": Command(
        "sheet", "draw faces with all that they can show: expressions, shapes of the mouth, turns", _sheet
    ),
}


def parser(version: str) -> argparse.ArgumentParser:
    """The whole command line."""
    top = argparse.ArgumentParser("facescript", description="A small language for faces, and its compiler.")
    top.add_argument("--version", action="version", version=f"facescript {version}")
    commands = top.add_subparsers(dest="command", required=True, metavar="COMMAND")
    for name, command in COMMANDS.items():
        command.options(commands.add_parser(name, help=command.help, description=command.help.capitalize() + "."))
    return top
