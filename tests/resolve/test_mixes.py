"""Sums of muscles, units, expressions and channels: what they drive, degrees, sides, parameters, circles."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from plays import codes, mix, resolved, verbs

from facescript.ir.acts import Add, Drop, Gesture, Show
from facescript.ir.values import Draw, Driver, Mix, Term


def shown(text: str) -> Mix:
    verb = verbs(text)[-1]
    assert isinstance(verb, Show | Add)
    return verb.mix


@pytest.mark.parametrize(
    ("written", "text"),
    [
        ("neutral", "neutral"),
        ("AU4 10%", "0.1 AU4 [brow.lower.left=1 brow.lower.right=1]"),
        ("brow.inner.left", "1 brow.inner.left [brow.inner.left=1]"),
        ("lid 20%", "0.2 lid [lid.left=1 lid.right=1]"),
        ("AU6.right 30%", "0.3 AU6.right [cheek.upper.right=1 lid.right=0.1]"),
        ("head.roll 8deg", "1 head.roll [head.roll=8]"),
        ("head.scale 10%", "0.1 head.scale [head.scale=1]"),
        ("eye.pitch -5deg", "1 eye.pitch [eye.left.pitch=-5 eye.right.pitch=-5]"),
        (
            "AU1 - AU2 30%",
            "1 AU1 [brow.inner.left=1 brow.inner.right=1] + -0.3 AU2 [brow.outer.left=1 brow.outer.right=1]",
        ),
        ("AU1 20% to 40%", "0.2..0.4 AU1 [brow.inner.left=1 brow.inner.right=1]"),
        ("AU1 half", "0.5 AU1 [brow.inner.left=1 brow.inner.right=1]"),
        ("AU1 half / 2", "0.25 AU1 [brow.inner.left=1 brow.inner.right=1]"),
        ("AU1 (half / 2)", "0.25 AU1 [brow.inner.left=1 brow.inner.right=1]"),
        (
            "(AU1 + AU4 half) half",
            "0.5 AU1 [brow.inner.left=1 brow.inner.right=1] + 0.25 AU4 [brow.lower.left=1 brow.lower.right=1]",
        ),
        ("blink.left", "1 blink.left [blink.left=1]"),
        ("chin 40%", "0.4 chin [chin.left=1 chin.right=1]"),
        ("ear -60%", "-0.6 ear [ear.left=1 ear.right=1]"),
        ("muzzle.left", "1 muzzle.left [muzzle.left=1]"),
    ],
)
def test_sums(written: str, text: str) -> None:
    assert mix(shown(f"let half = 50%\nshake half\nshow {written}\n")) == text


def test_nested_expressions_flatten_to_what_they_drive_at_their_full_degree() -> None:
    text = "expression a = AU1 50%\nexpression b = a 50% + AU1.left 10% + head.pitch -8deg\nshow b 80%\n"
    drivers = (Driver("brow.inner.left", 0.35), Driver("brow.inner.right", 0.25), Driver("head.pitch", -8.0))
    assert shown(text) == Mix((Term("b", 0.8, drivers),))


def test_parameters_and_their_defaults() -> None:
    text = "expression crooked(lift = 40%) = AU12.left + brow.outer.right (lift / 2)\nshow {}\n"
    assert mix(shown(text.format("crooked"))) == "1 crooked [cheek.lower.left=1 brow.outer.right=0.2]"
    assert mix(shown(text.format("crooked(lift = 60%) 80%"))) == "0.8 crooked [cheek.lower.left=1 brow.outer.right=0.3]"
    assert mix(shown(text.format("crooked(60%)"))) == "1 crooked [cheek.lower.left=1 brow.outer.right=0.3]"
    assert mix(shown(text.format("crooked.left"))) == "1 crooked.left [cheek.lower.left=1]"


def test_a_let_may_hold_a_sum() -> None:
    text = "let warm = AU12 40% + AU6 20%\nshow warm 50%\n"
    assert [(term.name, term.degree) for term in shown(text).terms] == [("AU12", 0.2), ("AU6", 0.1)]


def test_an_author_covers_the_library_for_what_is_built_on_it_too() -> None:
    text = "expression nodding = head.pitch -20deg\nnod 50%\n"
    play, diagnostics = resolved(text)
    assert play is not None
    assert [item.code for item in diagnostics] == ["FS210"]
    (nod,) = (item.verb for item in play.scenes[0].body.items)  # type: ignore[union-attr]
    assert isinstance(nod, Gesture)
    assert mix(nod.mix) == "1 nodding [head.pitch=-20]"


def test_gestures() -> None:
    tilts = verbs("tilt left 50%\ntilt right\nwink right\nblink for 2s\nnod 20% to 40%\n")
    assert all(isinstance(verb, Gesture) for verb in tilts)
    left, right, wink, _, nod = (verb for verb in tilts if isinstance(verb, Gesture))
    assert (left.degree, left.mix.terms[0].degree, right.mix.terms[0].degree) == (0.5, 1.0, -1.0)
    assert {driver.name.rsplit(".", 1)[1] for driver in wink.mix.terms[0].drivers} == {"right"}
    assert nod.degree == Draw(0.2, 0.4)


def test_drop_takes_names_as_they_were_written() -> None:
    text = (
        "action lift(what):\n    add what\n    drop what\n"
        "lift AU1.left\nadd head.scale 10%\ndrop head.scale\nnod as bow\ndrop bow\n"
    )
    assert [verb.name for verb in verbs(text) if isinstance(verb, Drop)] == ["AU1.left", "head.scale", "bow"]


@pytest.mark.parametrize(
    ("written", "code"),
    [
        ("smle", "FS201"),
        ("brow.iner", "FS201"),
        ("AU3", "FS201"),
        ("AU8", "FS219"),
        ("AU70", "FS219"),
        ("AU26.left", "FS220"),
        ("smile 40deg", "FS302"),
        ("head.roll", "FS234"),
        ("head.roll 50%", "FS302"),
        ("40%", "FS312"),
        ("2 * smile", "FS312"),
        ("smile 140%", "FS305"),
        ("lamp", "FS214"),
        ("gaze.yaw 3deg", "FS201"),
        ("smile(40%)", "FS218"),
    ],
)
def test_faults_of_sums(written: str, code: str) -> None:
    assert codes(f"target lamp at 0deg 0deg 2m\nlook at lamp\nshow {written}\n") == [code]


def test_expressions_in_a_circle_show_the_circle() -> None:
    (item,) = resolved("expression a = b 50%\nexpression b = c\nexpression c = a\nshow a\n")[1]
    assert item.code == "FS215"
    assert "a -> b -> c -> a" in item.message


def test_an_expression_that_doubles_at_every_step_is_bounded() -> None:
    lines = ["expression e0(x = 1%) = AU1 x"]
    lines += [f"expression e{n}(x = 1%) = e{n - 1}(x = x) + e{n - 1}(x = x)" for n in range(1, 40)]
    assert codes("\n".join(lines) + "\nshow e39(x = 2%)\n") == ["FS322"]


degrees = st.integers(0, 100)


@given(degrees, degrees)
def test_the_degree_scales_the_whole(inner: int, outer: int) -> None:
    nested = shown(f"expression e = AU12 {inner}%\nexpression f = e {outer}%\nshow f\n").terms[0]
    assert all(driver.value == pytest.approx(inner * outer / 10_000) for driver in nested.drivers)
    bracketed = shown(f"show (AU12 {inner}%) {outer}%\n").terms[0]
    assert bracketed.degree == pytest.approx(inner * outer / 10_000)


@given(st.permutations(["AU1", "AU4", "smile", "head.roll 3deg", "lid.left 20%"]))
def test_the_order_of_a_sum_does_not_matter_to_what_it_drives(terms: list[str]) -> None:
    drivers = shown(f"expression e = {' + '.join(terms)}\nshow e\n").terms[0].drivers
    other = shown("expression e = AU1 + AU4 + smile + head.roll 3deg + lid.left 20%\nshow e\n").terms[0].drivers
    assert {driver.name: pytest.approx(driver.value) for driver in drivers} == {d.name: d.value for d in other}


def test_a_part_that_a_face_lacks_is_hinted_at_where_it_is_named() -> None:
    """Not for what an expression of the library holds, which is for faces of all kinds."""
    assert codes("show ear 60%\n") == ["FS250"]
    assert codes("add AU1 + muzzle.left 20%\nshow surprise\n") == ["FS250"]
    assert codes("show surprise + AU1\n") == []
