"""Scripts as authors write them, with the files that they use, and edits of them: names change, faults come and go."""

from __future__ import annotations

import os
import re
from pathlib import Path
from random import Random

HEAD = """\
face ada = woman, voice en-us female
target lamp at 25deg 10deg 2m
target cup at 10cm -12cm 20cm
target crowd of (-60cm 0cm 2m) (0cm 5cm 2m) lamp
expression wry = smile.left 60% + brow.outer.right 30%
expression dry(lift = 40%) = wry + AU7 lift
let warm = 60%
let pause = 2s * 2
let greeting = "Hello, *you*. [nod]"
action greet(who, warmth = warm):
    look at who
    show smile warmth, over 400ms, as grin
    repeat 2 times:
        blink as b
    at grin.end: nod
life mine = calm, blink 8/min
event lamp arrives at 2s
when person arrives as guest:
    look at guest
    greet cup
viseme "θ" = "s" 80%
"""

SOUND = """\
nod 30%
show wry 80%, over 300ms
show dry(lift = 20%)
look at lamp for 1s
glance crowd.2
scan crowd, 400ms each
greet cup
greet camera, warmth 40%
say "My [look at cup]cup[/] [wait 300ms] and [read zhang3]y[/]."
say text "text.txt"
say ssml "x.ssml"
say greeting
at hello.end + 300ms: nod
at hello."evening": shake
wait pause
drop smile over 1s
repeat c in crowd: look at c
repeat row in "t.csv": show smile row.degree
repeat 2 times: say "Cup" as inner
together: show neutral
add brow.inner 40% for 800ms
look at people.nearest
life mine
ada: nod
"""

FAULTY = """\
show smlie 40%
shw smile
show smile 140%
wait 300
look at warm
show theirs
greet lamp as hello
at hello."nothing": nod
say "a [show] b *c"
say "x" from "no.wav"
link "example.com" "x"
say "unclosed
(
view somebody 120%
face bob = man
bob: nod
use "other.face"
act2 lamp
expression loop = loop
show loop
action say = nod
nod as say
expression bad = smlie + wry 140%
let loud = warm + 3s
target track from "t.csv"
scene s:
"""

FILES = {
    "other.face": (
        "expression theirs = smile 20%",
        "action act2(who): look at who as seen",
        "expression bad = smlie",
        "(",
    ),
    "text.txt": ("Some [nod] *text*", "cup", "[bad", "a *b"),
    "x.ssml": ('<speak>Hi <break time="1s"/></speak>', "<speak>", "<speak><b>x</b></speak>"),
    "t.csv": ("degree,text\n20%,Hi\n50%,Ho", "degree,text\nabc,Hm\n200%,x", "text\n"),
}

NAMES = ("wry", "lamp", "warm", "pause", "greet", "hello", "ada", "crowd", "cup", "mine", "who", "grin", "theirs")


def authored(chance: Random) -> str:
    """A script, in scenes or without."""
    body = ['say "Good evening, *you*." as hello', *chance.choices(SOUND.splitlines(), k=chance.randrange(3, 16))]
    if chance.random() < 0.4:
        body = ["scene one:", *(f"    {line}" for line in body), "scene two:", "    nod", "    greet lamp"]
    return HEAD + "\n".join(body) + "\n"


def revised(text: str, chance: Random) -> str:
    """One edit: a line more or less, a name that is another one here or everywhere, another number."""
    lines = text.splitlines()
    at, kind = chance.randrange(len(lines)), chance.random()
    indent = re.match(" *", lines[at])
    if kind < 0.3:
        new = chance.choice((SOUND if chance.random() < 0.6 else FAULTY).splitlines())
        lines.insert(at, (indent[0] if indent else "") + new)
    elif kind < 0.5:
        del lines[at]
    elif kind < 0.6:
        lines.insert(0, chance.choice(("", "# said", "expression more = smile", "let more = 3s", "nod")))
    elif kind < 0.8:
        old = chance.choice(NAMES)
        new = chance.choice((f"{old}x", "other", chance.choice(NAMES)))
        where = range(len(lines)) if chance.random() < 0.5 else (at,)
        for number in where:
            lines[number] = re.sub(rf"\b{old}\b", new, lines[number])
    else:
        lines[at] = re.sub(r"\d+", lambda _: str(chance.randrange(1, 90)), lines[at], count=1)
    return "\n".join(lines) + "\n"


def put(folder: Path, name: str, chance: Random) -> None:
    """Writes one of the files anew, or removes it."""
    path = folder / name
    if chance.random() < 0.15:
        path.unlink(missing_ok=True)
        return
    path.write_text("\n".join(chance.sample(FILES[name], chance.randrange(1, 3))) + "\n", "utf-8")
    if chance.random() < 0.5:  # as one that was written long ago
        time = 1e9 + chance.random() * 1e8
        os.utime(path, (time, time))
