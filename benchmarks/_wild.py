"""Scripts nobody would write: words in no order, spoilt scripts, plausible nonsense, and much too much of one thing.

All are drawn from one `random.Random`, so a seed and a count name a script. None is longer than `LONGEST` characters.
"""

from __future__ import annotations

from collections.abc import Callable
from random import Random

LONGEST = 30_000
"""Characters of a script: six hundred lines or more."""

WORDS = (
    "say look at glance scan show add drop nod shake tilt blink wink wait until together: choose: in turn: repeat "
    "times forever for over back in ease as face target film scene action expression let use when event life target "
    "camera people smile AU4 AU12.left head.yaw lid.left 40% 300ms 2s 10deg 60cm 2m 17/min 3 "
    '"Hello *you*." "[smile]a[/]" "[read zhang3]长[/]大" "cup".2 on "cup": play "take.csv" from timed "x.vtt" '
    "( ) + - * / , : . = # #ff8800 1280x720 left right ada bruno hello.end hello. crowd.nearest crowd.2 away to each "
    "eyes only head then speed latency moves of with resume restart stop person arrives as guest heard touched key "
    "signal nearest first random background view all calm unseen woman voice en-us cmn rate pitch 中文 0 -1 1e9 0.5 "
    "99999999999999999999 1000000000s 0s 0% 500% 1fps 8192x8192 screen patent wide long seed"
).split()
SIGNS = (
    "\t\"'()[]{}+-*/,.:;=#%|\\ \n\u201c\u201d\uff0c\uff1a\u200f\u0000\u4e2d\u00e9\U0001f600\ufeff\u2028\r\v\x1b\u0660"
    "\u0301\ud7ff9_~`!?&@^$<>"
)
NUMBERS = (
    "0",
    "1",
    "2",
    "7",
    "0.5",
    "1.25",
    "60",
    "100000",
    "99999999999999999999",
    "0.000001",
    "007",
    "-3",
    "1" * 400,
)
UNITS = ("ms", "s", "deg", "cm", "m", "%", "/min", "fps", "", "x720", "hz", "min", "km")
AIMS = (
    "camera",
    "lamp",
    "visitor",
    "crowd.2",
    "crowd.nearest",
    "bruno.mouth",
    "people",
    "away",
    "guest",
    "(1cm 2cm 3cm)",
)
SUMS = (
    "smile",
    "wry 80%",
    "AU4 30% + AU7",
    "deep(40%) * 2",
    "smile.left - smile.left",
    "head.roll 8deg",
    "neutral",
    "AU1.lft",
)
TEXTS = (
    '"Good [brows 50%]evening[/], everyone. | I have lost my *cup*."',
    '"小明在长城脚下[read zhang3]长[/]大，*一定*要去。"',
    '"[nod][look at lamp]one[/] two [wait 300ms]three"',
    '"[[[[smile]]]]"',
    '"' + "word " * 300 + '"',
    '"سلام دنیا עברית नमस्ते 😀 \\[ \\* \\|"',
    '""',
    '"..."',
)


def amount(chance: Random, *units: str) -> str:
    """A quantity: mostly of one of `units`, now and then of any size and any unit."""
    if units and chance.random() < 0.9:
        return f"{chance.choice(('0', '0.5', '1', '2', '40', '300'))}{chance.choice(units)}"
    return chance.choice(NUMBERS) + chance.choice(UNITS)


def invented(chance: Random) -> str:
    """Words of the language in no order, on indented lines."""
    lines = []
    for _ in range(chance.randrange(1, 14)):
        words = " ".join(chance.choice(WORDS) for _ in range(chance.randrange(1, 9)))
        lines.append(" " * 4 * chance.randrange(0, 4) + words)
    return "\n".join(lines) + "\n"


def mutated(text: str, chance: Random) -> str:
    """A script with a few signs or lines changed, moved, doubled or lost."""
    for _ in range(chance.randrange(1, 5)):
        at, length = chance.randrange(len(text) + 1), chance.randrange(0, 30)
        piece = text[at : at + length]
        kind = chance.randrange(6)
        new = (chance.choice(SIGNS), "", piece * 2, f" {chance.choice(WORDS)} ", piece[::-1], amount(chance))[kind]
        text = text[:at] + new + text[at + length :]
    return text


# ------------------------------------------------------------------------------------------------ plausible nonsense

HEAD = """\
film 1280x720, 30fps, 60s long, seed 7
face ada = woman, voice en-us female
face bruno = man, voice cmn
target lamp at 25deg 10deg 2m
target visitor moves
    0s -80cm 0cm 2m
    4s 80cm 10cm 2m
target crowd of (-60cm 0cm 2m) (0cm 5cm 2m) lamp visitor
let beat = 400ms
expression wry = smile.left 60% + brow.outer.right 30%
expression deep(lift = 40%) = brows lift + wry lift / 2
action greet(who, warmth = 60%):
    look at who, eyes then head
    show smile warmth over beat
"""


def played(chance: Random) -> str:
    """A script that may well mean something: statements of all kinds in blocks of all kinds, with reactions."""
    lines = [HEAD] if chance.random() < 0.9 else []
    if chance.random() < 0.2:
        lines.append(
            f'use "{chance.choice(("studio.face", "hello.face", "nowhere.face", "fuzz.face", "../x.face"))}"\n'
        )
    for number in range(chance.randrange(1, 4)):
        lines.append(f"scene part{number}:\n" + _block(chance, 1, chance.randrange(1, 7)))
    for _ in range(chance.randrange(0, 4)):
        what = chance.choice(
            ('heard "no"', 'key "q"', "person arrives as guest", "person nearest as guest", "person leaves")
        )
        end = chance.choice(("", "    restart\n", "    stop\n", "    resume\n"))
        lines.append(f"when {what}:\n" + _block(chance, 1, chance.randrange(1, 4)) + end)
    for _ in range(chance.randrange(0, 5)):
        what = chance.choice(('heard "no"', 'key "q"', "visitor arrives", "lamp arrives", "visitor leaves"))
        lines.append(f"event {what} at {amount(chance, 's', 'ms')}\n")
    return "".join(lines)


def _block(chance: Random, depth: int, count: int) -> str:
    return "".join(_statement(chance, depth) for _ in range(count))


def _statement(chance: Random, depth: int) -> str:
    pad = " " * 4 * depth
    if depth < 6 and chance.random() < 0.35:
        return pad + _opening(chance) + "\n" + _block(chance, depth + 1, chance.randrange(1, 4))
    line = f"{pad}{chance.choice(('ada: ', 'ada: ', 'bruno: ', ''))}{_line(chance)}"
    if chance.random() < 0.15:
        line += f" as {chance.choice('abc')}"
    line += "\n"
    if "say" in line and chance.random() < 0.4:
        word = chance.choice(("cup", "everyone", "一定", "word"))
        line += f'{pad}    on "{word}": {_line(chance)}\n'
    return line


def _opening(chance: Random) -> str:
    mark = chance.choice("abc") + chance.choice((".start", ".end", "", ".end + 300ms", '."cup"'))
    return chance.choice(
        (
            "together:",
            "choose:",
            "in turn:",
            "bruno:",
            f"at {amount(chance, 's', 'ms')}:",
            f"at {mark}:",
            f"repeat {chance.choice(('2', '3', '0', '7', '100000'))} times:",
            f"repeat for {amount(chance, 's')}:",
            "repeat forever:",
            "repeat one in crowd:",
            'repeat row in "trials.csv":',
        )
    )


def _line(chance: Random) -> str:
    times = "".join(
        f" {word} {amount(chance, 's', 'ms')}" for word in ("over", "for", "back in") if chance.random() < 0.2
    )
    kind = chance.randrange(10)
    if kind < 3:
        aim = chance.choice(AIMS)
        return f"{chance.choice(('look at', 'glance'))} {aim}{times}{chance.choice(('', ', eyes only', ', head 40%'))}"
    if kind == 3:
        return f"scan {chance.choice(('crowd', 'people', 'lamp'))}, {amount(chance, 'ms')} each"
    if kind < 6:
        return f"{chance.choice(('show', 'add', 'drop'))} {chance.choice(SUMS)}{times}"
    if kind == 6:
        return f"say {chance.choice(TEXTS)}"
    if kind == 7:
        return f"wait {chance.choice(('', 'until '))}{amount(chance, 's', 'ms')}"
    if kind == 8:
        return f"greet {chance.choice(AIMS)}, warmth {amount(chance, '%')}"
    return chance.choice(
        ("nod", "shake 30%", "tilt left", "blink", "wink right", "view ada 180%", "background #fff000", "life calm")
    )


# ------------------------------------------------------------------------------------------------ too much of one thing


def overgrown(chance: Random) -> str:
    """Much too much of one thing."""
    count = int(10 ** (chance.random() * 3.7))
    return chance.choice(PLENTY)(count, chance)[:LONGEST]


def _looks_by_repeat(count: int, chance: Random) -> str:
    lines = [f"repeat {count} times:", *["repeat 3 times:"] * chance.randrange(0, 4)]
    lines = ["    " * depth + line for depth, line in enumerate(lines)]
    pad = "    " * len(lines)
    body = chance.choice((("look left 20deg", "look right"), ("look away",), ("nod", "show smile"), ('say "Well."',)))
    return "\n".join([*lines, *(pad + line for line in body)]) + "\n"


def _nested(count: int, chance: Random) -> str:
    opening = chance.choice(
        ("repeat 2 times:", "together:", "in turn:", "choose:", "at 1s:", "repeat for 9s:", "face:")
    )
    depth = min(count, 240)
    return "".join("    " * level + opening + "\n" for level in range(depth)) + "    " * depth + "nod\n"


def _following(count: int, chance: Random) -> str:
    """Looks and glances around one moving target, overlapping or not."""
    step, verb = chance.choice(("20ms", "150ms", "1s")), chance.choice(("look at", "glance"))
    lasting = chance.choice(("", " for 3s", " for 90ms", " over 0ms"))
    keys = "".join(f"    {number}s {number % 90}cm 0cm 2m\n" for number in range(chance.choice((2, 30, 300))))
    body = f"    {verb} it{lasting}\n    at {step}: look at camera\n    wait {step}\n"
    return f"target it moves\n{keys}repeat {count} times:\n{body}"


def _looks(count: int, chance: Random) -> str:
    lines = [f"at {number * 0.1:.1f}s: look at it for {amount(chance, 's')}\n" for number in range(count)]
    return "target it moves\n    0s -80cm 0cm 2m\n    60s 80cm 0cm 2m\n" + "".join(lines)


def _chain(count: int, chance: Random) -> str:
    """Definitions that lead to each other, in a row, in a circle or by twos."""
    last = chance.choice(("nod", "b0", f"b{count - 1}"))
    kind = chance.randrange(5)
    rows = []
    for number in range(count):
        to = f"b{number + 1}" if number < count - 1 else last
        rows.append(
            (
                f"action b{number}:\n    {to}\n",
                f"action b{number}:\n    {to}\n    {to}\n",
                f"let b{number} = {to if to != 'nod' else '2s'} + {to if to != 'nod' else '2s'}\n",
                f"expression b{number} = {to if to != 'nod' else 'smile'} 50% + {to if to != 'nod' else 'smile'}\n",
                f"expression b{number}(x = 50%) = {to + '(x + x)' if to != 'nod' else 'smile x'}\n",
            )[kind]
        )
    return "".join(rows) + ("b0\n", "b0\n", "wait b0\n", "show b0\n", "show b0(10%)\n")[kind]


def _arguments(count: int, chance: Random) -> str:
    """Actions that hand an argument on, each time more of it."""
    rows = [
        f"action b{number}(x):\n    b{number + 1} x {chance.choice(('', '+ x', '* 2'))}\n" for number in range(count)
    ]
    return "".join(rows) + f"action b{count}(x):\n    wait x\nb0 1ms\n"


def _brackets(count: int, chance: Random) -> str:
    left, right = chance.choice((("(", ")"), ("[", "]"), ("deep(", ")"), ("(1s + ", ")"), ("(smile + ", ")")))
    before = chance.choice(("wait ", "show ", "let x = ", 'say "', "expression e = ", "look at "))
    return f"{before}{left * count}1s{right * (count if chance.random() < 0.7 else count - 1)}\n"


def _sum(count: int, chance: Random) -> str:
    term = chance.choice(("smile 1%", "AU4", "1s", "head.roll 2deg", "2", "nothing"))
    between = chance.choice((" + ", " - ", " * ", ", ", " "))
    return f"{chance.choice(('show', 'add', 'wait', 'let x ='))} {between.join([term] * count)}\n"


def _events(count: int, chance: Random) -> str:
    """A scene that events break into, start again or stop."""
    end = chance.choice(("resume", "restart", "stop"))
    gap = chance.choice((0.01, 0.3, 2.0))
    say = chance.choice(('say "Stop it, please."', "nod", "look at visitor for 1s", "wait 1s"))
    scene = chance.choice(
        ('say "A long line that is broken off again and again."', "repeat 50 times:\n    look left\n    nod\n")
    )
    happen = "".join(f'event heard "no" at {number * gap:.2f}s\n' for number in range(count))
    more = chance.choice(("", "when person nearest:\n    blink\n", 'when heard "no":\n    look away for 300ms\n'))
    people = "event visitor arrives at 0s\nevent lamp arrives at 1s\n" if more else ""
    setting = "target lamp at 25deg 10deg 2m\ntarget visitor moves\n    0s -80cm 0cm 2m\n    4s 80cm 10cm 2m\n"
    return f'{setting}{scene}\nwhen heard "no":\n    {say}\n    {end}\n{more}{people}{happen}'


def _same_line(count: int, chance: Random) -> str:
    return (_line(chance) + chance.choice(("", " as a", " as a as b", ",", " +", ":", "=")) + "\n") * count


def _labels(count: int, chance: Random) -> str:
    """Marks that hang on the next, forwards, backwards or in a circle."""
    way = chance.choice((1, -1))
    rows = [
        f"at a{(number + way) % max(1, count)}.{chance.choice(('end', 'start'))} + 1ms: nod as a{number}\n"
        for number in range(count)
    ]
    return "".join(rows[: chance.choice((count, max(1, count - 1)))]) + f"nod as a{count - 1}\n"


def _names(count: int, chance: Random) -> str:
    kind = chance.choice(
        ("face {} = woman", "target {} at 10deg 0deg 1m", "let {} = 1s", "expression {} = smile", "life {} = calm")
    )
    used = chance.random() < 0.5
    rows = [kind.format(f"name{number if chance.random() < 0.95 else 0}") for number in range(count)]
    return "\n".join(rows) + "\n" + "".join(f"wait nmae{number}\n" for number in range(count) if used)


def _long_text(count: int, chance: Random) -> str:
    piece = chance.choice(
        (
            "word ",
            "[nod]a ",
            "[smile 10%]b[/] ",
            "*c* | ",
            "长",
            "[wait 1s]",
            "[",
            "\\[",
            "[[/]",
            "1234567890",
            "a" * 40,
            "*",
        )
    )
    return f'say "{piece * count}"\n'


def _table(count: int, chance: Random) -> str:
    depth = min(count, 9)
    rows = "".join("    " * level + f'repeat r{level} in "trials.csv":\n' for level in range(depth))
    return rows + "    " * depth + f"wait r{depth - 1}.soa\n"


def _cues(count: int, chance: Random) -> str:
    rows = "".join(f'    on "word".{number}: {_line(chance)}\n' for number in range(1, count + 1))
    return f'{HEAD}scene a:\n    ada: say "{"word " * count}"\n' + rows.replace("    on", "        on")


def _crowd(count: int, chance: Random) -> str:
    members = " ".join(f"({number % 90}cm 0cm 2m)" for number in range(count))
    inner = chance.choice(("look at one", "scan crowd, 600ms each", "glance crowd.nearest", "repeat two in crowd: nod"))
    return f"target crowd of {members}\nscan crowd, 300ms each, nearest first\nrepeat one in crowd:\n    {inner}\n"


def _faces(count: int, chance: Random) -> str:
    rows = [f"face f{number} = {chance.choice(('woman', 'man', 'unseen'))}\n" for number in range(count)]
    looks = [f"    f{number}: look at f{(number * 7 + 1) % count}.mouth\n" for number in range(count)]
    return "".join(rows) + "scene a:\n" + "".join(looks)


PLENTY: tuple[Callable[[int, Random], str], ...] = (
    _looks_by_repeat, _nested, _following, _looks, _chain, _arguments, _brackets, _sum, _events, _same_line, _labels,
    _names, _long_text, _table, _cues, _crowd, _faces,
)  # fmt: skip


def wild(grown: list[str], chance: Random) -> str:
    """Any of them; `grown` are whole scripts to spoil."""
    draw = chance.random()
    if draw < 0.25:
        return invented(chance)
    if draw < 0.6:
        return mutated(chance.choice(grown), chance)
    if draw < 0.8:
        return played(chance)
    if draw < 0.9:
        return mutated(played(chance), chance)
    return overgrown(chance)
