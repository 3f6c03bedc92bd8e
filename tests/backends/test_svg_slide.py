"""What keeps its form slides: one translation says it all; and work that processes share gives the same bytes."""

from __future__ import annotations

import multiprocessing
import os
import time
from pathlib import Path

import numpy as np
import pytest

from facescript.backends.job import JobFailure
from facescript.backends.svg.slide import Slide
from facescript.backends.svg.spread import spread
from facescript.cli.main import main

TIMES = np.arange(0, 1.0, 0.01)
FORM = np.array([(0.0, 0.0), (12.0, 1.0), (9.0, 8.0), (-4.0, 6.0)])
QUANTUM = 0.25


def moved(stretch: float) -> np.ndarray:
    """The form going up and down by 12 px, and growing by some share of it."""
    way = 6 - 6 * np.cos(TIMES * 12)
    return FORM * (1 + stretch * way[:, None, None]) + np.stack([0 * way, way], axis=1)[:, None]


def test_a_form_that_is_kept_slides() -> None:
    points = moved(0.0)
    slide = Slide.of(points[::9])
    assert slide is not None
    beside = slide.follow(TIMES, points, QUANTUM)
    assert len(slide.keys.times) < len(TIMES) / 3
    assert np.abs(beside - FORM + FORM.mean(axis=0)).max() < 0.25


def test_what_changes_its_form_or_hardly_moves_does_not() -> None:
    assert Slide.of(moved(0.2)[::9]) is None
    assert Slide.of(FORM + np.zeros((9, 1, 1))) is None


@pytest.mark.parametrize("jobs", [1, 2, 3, 20])
def test_processes_share_the_work(jobs: int) -> None:
    assert spread(range(7), lambda number: (number, number**2), jobs) == [(number, number**2) for number in range(7)]
    assert spread([], str, jobs) == []


def test_a_process_that_ends_is_told() -> None:
    def work(number: int) -> int:
        return number if os.getpid() == here else os._exit(1)

    here = os.getpid()
    with pytest.raises(JobFailure):
        spread(range(4), work, 2)


def test_an_interrupt_ends_all_processes_without_a_word(capfd: pytest.CaptureFixture[str]) -> None:
    def work(number: int) -> int:
        waits = 1.0 if os.getpid() == here else 60.0 if number == 1 else 0.0
        time.sleep(waits)
        raise KeyboardInterrupt

    here = os.getpid()
    with pytest.raises(KeyboardInterrupt):
        spread(range(3), work, 3)
    assert not multiprocessing.active_children()
    assert capfd.readouterr().err == ""


def test_the_file_is_the_same_whatever_the_processes(tmp_path: Path) -> None:
    (tmp_path / "script.face").write_text("film 320x240, 400ms long, seed 3\nface ada = woman\nada: nod\n", "utf-8")
    for jobs in "13":
        target = tmp_path / f"{jobs}.svg"
        assert main(["build", str(tmp_path / "script.face"), "-o", str(target), "--jobs", jobs, "--quiet"]) == 0
    assert (tmp_path / "1.svg").read_bytes() == (tmp_path / "3.svg").read_bytes()
