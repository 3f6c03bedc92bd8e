"""Whatever an author writes, the compiler answers: scripts nobody would write, spoilt ones, and any text at all.

`benchmarks/fuzz.py` runs a hundred thousand of these and times each.
"""

from __future__ import annotations

from pathlib import Path
from random import Random

from _wild import HEAD, invented, mutated, overgrown, played
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from facescript.compile import Compiled, compile_source
from facescript.diagnostics.model import Severity
from facescript.speech.estimate import EstimatedVoice
from facescript.syntax.formatter import format_source
from facescript.text import Source
from facescript.world import World

EXAMPLES = Path(__file__).parents[2] / "examples"
SCRIPTS = [path.read_text("utf-8") for path in sorted(EXAMPLES.glob("*.face"))]
SEEDS = st.integers(0, 2**32)


def answered(text: str) -> Compiled:
    """A script compiled and laid out: it comes to a score, or the author is told why not, and where."""
    source = Source("fuzz.face", text)
    done = compile_source(source, World(EXAMPLES), EstimatedVoice())
    assert (done.score is None) == any(item.severity is Severity.ERROR for item in done.diagnostics)
    for item in done.diagnostics:
        assert item.message
        assert item.span is None or 0 <= item.span.start <= item.span.end <= len(item.span.source.text)
    assert format_source(Source("fuzz.face", format_source(source))) == format_source(source)
    return done


@given(SEEDS)
@settings(max_examples=300, deadline=None)
def test_words_in_no_order(seed: int) -> None:
    answered(invented(Random(seed)))


@given(st.sampled_from([*SCRIPTS, HEAD]), SEEDS)
@settings(max_examples=200, deadline=None)
def test_spoilt_scripts(text: str, seed: int) -> None:
    answered(mutated(text, Random(seed)))


@given(SEEDS)
@settings(max_examples=200, deadline=None)
def test_plausible_nonsense(seed: int) -> None:
    answered(played(Random(seed)))


@given(SEEDS)
@settings(max_examples=40, deadline=None, suppress_health_check=[HealthCheck.too_slow])
def test_too_much_of_one_thing(seed: int) -> None:
    answered(overgrown(Random(seed)))


@given(st.text(max_size=200))
@settings(max_examples=200, deadline=None)
def test_any_text(text: str) -> None:
    answered(text)


def test_scripts_of_the_project_are_answered_by_scores() -> None:
    """The check above could not fail on what never comes as far as a score."""
    assert all(answered(text).score is not None for text in SCRIPTS)
