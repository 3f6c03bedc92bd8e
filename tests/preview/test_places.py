"""Places in UTF-16 units, places carried over an edit, and the playhead that is bound to a statement."""

from __future__ import annotations

import pytest

from facescript.preview.places import Units, carried
from facescript.preview.playhead import Stretch, moved

WIDE = "a😀b😀\nc"


def test_places_are_counted_in_units_and_back() -> None:
    units = Units(WIDE)
    for offset in range(len(WIDE) + 1):
        wanted = len(WIDE[:offset].encode("utf-16-le")) // 2
        assert units.at(offset) == wanted
        assert units.offset(wanted) == offset


def test_a_place_within_a_character_is_before_it() -> None:
    assert Units(WIDE).offset(2) == 1


@pytest.mark.parametrize("units", [-1, 99])
def test_a_place_beyond_the_text_is_its_end(units: int) -> None:
    assert Units(WIDE).offset(units) == (0 if units < 0 else len(WIDE))


BEFORE = "wait 1s\nshow smile\nnod\nwait 2s\n"


def test_lines_that_stayed_keep_their_places() -> None:
    after = "wait 1s\n# new\nshow smile\nwait 2s\n"
    carry = carried(BEFORE, after)
    for line in ("wait 1s", "show smile", "wait 2s"):
        assert carry(BEFORE.index(line)) == after.index(line)
    assert carry(BEFORE.index("nod")) is None


def test_a_line_that_was_edited_is_the_same_line() -> None:
    after = BEFORE.replace("smile", "frown 60%")
    assert carried(BEFORE, after)(BEFORE.index("show smile")) == after.index("show frown")


def test_two_edits_at_once_are_told_apart() -> None:
    after = BEFORE.replace("wait 1s", "wait 9s\nblink").replace("wait 2s", "wait 9s")
    carry = carried(BEFORE, after)
    assert carry(BEFORE.index("nod")) == after.index("nod")


ACTS = [Stretch(0.0, 1.0, 0, 0), Stretch(1.0, 2.0, 10, 0), Stretch(2.0, 3.0, 10, 1)]


def test_the_playhead_stays_as_far_into_its_statement() -> None:
    later = [Stretch(0.0, 3.0, 0, 0), Stretch(3.0, 4.0, 15, 0), Stretch(4.0, 5.0, 15, 1)]
    carry = {0: 0, 10: 15}.get
    assert moved(1.25, ACTS, later, carry) == 3.25
    assert moved(2.25, ACTS, later, carry) == 4.25, "the second pass of a repeat is not the first"


def test_the_playhead_does_not_leave_a_statement_that_became_shorter() -> None:
    assert moved(1.9, ACTS, [Stretch(1.0, 1.5, 10, 0)], {10: 10}.get) == 1.5


def test_where_its_statement_is_gone_the_playhead_keeps_to_the_one_before() -> None:
    assert moved(1.5, ACTS, [Stretch(4.0, 5.0, 0, 0)], {0: 0}.get) == 5.5
    assert moved(1.5, ACTS, [], {}.get) == 1.5
