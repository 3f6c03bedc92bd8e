"""When blocks with a clock of their own are played: calls of actions and passes of a repeat."""

from __future__ import annotations

from scheduling import scheduled

SCRIPT = """\
action bow(much):
    nod much
    in turn:
        blink
scene a:
    wait 1s
    together:
        bow 40%
        shake
    repeat 2 times:
        tilt left
    bow 20%
"""


def test_calls_and_passes_have_their_times_and_other_blocks_none() -> None:
    score = scheduled(SCRIPT).solved
    found = [(block.span.text.split("\n")[0], block.start, round(block.settled, 6)) for block in score.blocks]
    assert found == [
        ("bow 40%", 1.0, 2.0),
        ("repeat 2 times:", 2.0, 2.9),
        ("repeat 2 times:", 2.9, 3.8),
        ("bow 20%", 3.8, 4.8),
    ]
