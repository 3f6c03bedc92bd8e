"""Browser tests are skipped, and say so, where there is no Chromium; those of the editor where it cannot be built."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest
from chromium import program

HERE = Path(__file__).parent
WEB = HERE.parents[1] / "editors" / "web"


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    if program() is None:
        for item in items:
            if HERE in item.path.parents:
                item.add_marker(pytest.mark.skip(reason="no Chromium on this machine"))


@pytest.fixture(scope="session")
def editor(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The editor of the preview's page, built anew."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("the editor is built with node and npm")
    if not (WEB / "node_modules" / "esbuild").is_dir():
        done = subprocess.run(["npm", "ci"], cwd=WEB, capture_output=True, text=True)
        if done.returncode:
            pytest.skip("npm could not fetch the editor's packages")
    folder = tmp_path_factory.mktemp("editor")
    subprocess.run(["node", str(WEB / "bundle.mjs"), str(folder)], check=True)
    return folder / "editor.js"
