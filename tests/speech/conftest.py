"""Skips what needs the synthesiser where its package is not installed."""

from __future__ import annotations

import pytest


@pytest.fixture(scope="session")
def synthesiser() -> None:
    pytest.importorskip("espeakng_loader", reason="the package espeakng-loader is not installed")
