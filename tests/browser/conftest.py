"""Browser tests are skipped, and say so, where there is no Chromium."""

from __future__ import annotations

from pathlib import Path

import pytest
from chromium import program

HERE = Path(__file__).parent


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if program() is None:
        for item in items:
            if HERE in item.path.parents:
                item.add_marker(pytest.mark.skip(reason="no Chromium on this machine"))
