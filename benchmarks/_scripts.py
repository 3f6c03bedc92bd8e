"""Scripts of a wanted length for the benchmarks: what authors write, over and over, with other names and numbers."""

from __future__ import annotations

HEAD = """\
film {size}, {fps}fps, seed 7
face ada = woman, voice en-us female
    life {life}
target lamp at 25deg 10deg 2m
target cup at 10cm -12cm 20cm
target crowd of (-60cm 0cm 2m) (0cm 5cm 2m) (50cm 10cm 2m)
expression wry = smile.left 60% + brow.outer.right 30% + AU7 20%
action greet(who, warmth = 60%):
    look at who, eyes then head
    together:
        show smile warmth over 400ms
        nod
"""

PART = """\
scene part{number}:
    # part {number}
    greet camera, warmth {degree}%
    say "Good evening, everyone. | I have lost my *cup*." as line{number}
        on "cup": glance cup, eyes only
    at line{number}.end + 300ms: add brow.inner 40% for 800ms
    together:
        look at lamp for {length}s
        show wry 80% over 300ms
    repeat 2 times:
        nod 30%
        wait 250ms
    drop smile over 1s
    in turn:
        look at crowd.2
        wait 200ms
    scan crowd, 400ms each
    choose:
        blink
        wink left
    show neutral over {length}s
"""

TALK = (
    "Good evening, and welcome to the programme. | Tonight we look at bridges, boats and the people who build them. "
    "Some of them have worked by the river for forty years. | Others came only last spring, "
    "and have already made it their home. "
)


def lines_of(count: int, size: str = "1280x720", fps: int = 30, life: str = "still") -> str:
    """A script of at least `count` lines."""
    text = HEAD.format(size=size, fps=fps, life=life)
    number = 0
    while text.count("\n") < count:
        number += 1
        text += PART.format(number=number, degree=40 + number % 50, length=1 + number % 3)
    return text


def talk(seconds: float, size: str = "1920x1080", fps: int = 30, life: str = "announcer", face: str = "woman") -> str:
    """A face, a woman's if no other is wanted, that speaks without end and lives, cut after `seconds`."""
    says = "".join(f'    say "{TALK}" as talk{number}\n    nod 30%\n' for number in range(1, int(seconds / 8) + 3))
    return (
        f"film {size}, {fps}fps, {seconds:g}s long, seed 7\nface ada = {face}, voice en-us female\n"
        f"    life {life}\nscene talk:\n    show smile 30%\n{says}"
    )
