"""Quantities: units to base units, arithmetic, draws, moments; and what is refused."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from plays import codes, dos, play_of, resolved, verbs

from facescript.ir.acts import At, Wait
from facescript.ir.values import Draw, Mark, Moment


@pytest.mark.parametrize(
    ("written", "seconds"),
    [
        ("2s", 2.0),
        ("300ms", 0.3),
        ("1.5s", 1.5),
        ("2 * beat", 0.6),
        ("beat * 2", 0.6),
        ("beat + 1s", 1.3),
        ("1s - beat", 0.7),
        ("1s - beat - beat", 0.4),
        ("(1s + beat) / 2", 0.65),
        ("1s + beat / 3", 1.1),
        ("beat * (2s / 1s)", 0.6),
        ("half * 2s", 1.0),
    ],
)
def test_arithmetic(written: str, seconds: float) -> None:
    (wait,) = verbs(f"let beat = 300ms\nlet half = 50%\nwait {written}\nlook left 20deg, speed half for beat\n")[:1]
    assert isinstance(wait, Wait)
    assert wait.duration == pytest.approx(seconds)


@pytest.mark.parametrize(
    ("written", "low", "high"),
    [
        ("2s to 6s", 2.0, 6.0),
        ("2 * (1s to 2s)", 2.0, 4.0),
        ("(1s to 2s) + 1s", 2.0, 3.0),
        ("5s - (1s to 2s)", 3.0, 4.0),
    ],
)
def test_draws(written: str, low: float, high: float) -> None:
    (wait,) = verbs(f"wait {written}\n")
    assert wait == Wait(Draw(low, high))


@pytest.mark.parametrize(
    ("written", "code"),
    [
        ("2", "FS301"),
        ("2m", "FS302"),
        ("20deg", "FS302"),
        ("40%", "FS302"),
        ("2min", "FS303"),
        ("-1s", "FS304"),
        ("100000s", "FS304"),
        ("2s + 1deg", "FS306"),
        ("2s * 3s", "FS306"),
        ("2s / 0", "FS306"),
        ("6s to 2s", "FS306"),
        ("2s to 40%", "FS306"),
        ("(1s to 2s) + (1s to 2s)", "FS306"),
        ("2s / (1 to 2)", "FS306"),
        ("pase", "FS207"),
        ("smile", "FS214"),
        ("2s 3s", "FS312"),
        ('"long"', "FS312"),
    ],
)
def test_faults_of_quantities(written: str, code: str) -> None:
    assert codes(f"wait {written}\n") == [code]


def test_a_metre_that_was_meant_as_a_minute_gets_its_fix() -> None:
    (item,) = resolved("wait 2m\n")[1]
    assert item.message == "`2m` is metres; a time belongs here, `120s`?"
    assert item.fixes[0].edits[0].text == "120s"


@pytest.mark.parametrize("written", ["40", "0.4"])
def test_a_bare_number_gets_its_unit(written: str) -> None:
    (item,) = resolved(f"show smile {written}\n")[1]
    assert (item.code, item.fixes[0].edits[0].text) == ("FS301", "40%")


def moments(text: str) -> list[Moment]:
    return [node.moment for node in play_of(text).scenes[0].body.items if isinstance(node, At)]


@pytest.mark.parametrize(
    ("written", "moment"),
    [
        ("2s", Moment(2.0)),
        ("hello.start", Moment(0.0, Mark("hello", "start"))),
        ("hello", Moment(0.0, Mark("hello", "start"))),
        ("hello.end + 300ms", Moment(0.3, Mark("hello", "end"))),
        ("300ms + hello.end", Moment(0.3, Mark("hello", "end"))),
        ('hello."cup"', Moment(0.0, Mark("hello", "start", "cup", 1))),
        ('hello."cup".2 - 100ms', Moment(-0.1, Mark("hello", "start", "cup", 2))),
        ('hello."cup".2.end', Moment(0.0, Mark("hello", "end", "cup", 2))),
        ('hello."cup".end', Moment(0.0, Mark("hello", "end", "cup", 1))),
        ("hello.end + (100ms to 200ms)", Moment(Draw(0.1, 0.2), Mark("hello", "end"))),
    ],
)
def test_moments(written: str, moment: Moment) -> None:
    assert moments(f'at {written}: nod\nsay "A cup, a cup." as hello\n') == [moment]


@pytest.mark.parametrize(
    ("written", "code"),
    [
        ("hullo.end", "FS205"),
        ("hello.middle", "FS233"),
        ('hello."cap"', "FS228"),
        ('hello."cup".3', "FS229"),
        ("2 * hello.end", "FS306"),
        ("hello.end + hello.start", "FS306"),
        ("2s - hello.end", "FS306"),
        ("-1s", "FS304"),
        ("2m", "FS302"),
        ('bow."cup"', "FS230"),
    ],
)
def test_faults_of_moments(written: str, code: str) -> None:
    assert codes(f'at {written}: nod\nsay "A cup, a cup." as hello\nshake as bow\n') == [code]


def test_a_moment_is_no_length() -> None:
    assert codes('say "Hello." as hello\nwait hello.end\n') == ["FS328"]


def test_override_of_a_let() -> None:
    text = "let beat = 300ms\nwait 2 * beat\n"
    (wait,) = dos(play_of(text, overrides={"beat": "1s + 200ms"}).scenes[0].body)
    assert wait.verb == Wait(2.4)
    for overrides, code in (({"beet": "1s"}, "FS232"), ({"beat": "1s, 2s"}, "FS312"), ({"beat": "20deg"}, "FS302")):
        assert [item.code for item in resolved(text, overrides=overrides)[1]] == [code]


counts = st.integers(1, 50)
times = st.integers(0, 5000)


@given(counts, times, times)
def test_products_spread_over_sums(count: int, first: int, second: int) -> None:
    one, two = verbs(f"wait {count} * ({first}ms + {second}ms)\nwait {count} * {first}ms + {count} * {second}ms\n")
    assert isinstance(one, Wait)
    assert isinstance(two, Wait)
    assert one.duration == pytest.approx(two.duration)


@given(times, times)
def test_what_is_added_can_be_taken_away(first: int, second: int) -> None:
    (wait,) = verbs(f"wait {first}ms + {second}ms - {second}ms\n")
    assert isinstance(wait, Wait)
    assert wait.duration == pytest.approx(first / 1000)
