"""One preview for all tests of a run, as its process takes seconds to be ready; and the editor of its page."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from serving import PARTS, SCRIPT, Serving

ROOT = Path(__file__).parents[2]
WEB = ROOT / "editors" / "web"


@pytest.fixture(scope="session")
def serving(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Serving]:
    folder = tmp_path_factory.mktemp("preview")
    (folder / "parts.face").write_text(PARTS, "utf-8")
    os.environ["PYTHONPATH"] = str(ROOT)
    with Serving(folder, SCRIPT) as serving:
        yield serving


@pytest.fixture(scope="session")
def editor(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """What `make playground` builds."""
    if shutil.which("node") is None or shutil.which("npm") is None:
        pytest.skip("the editor is built with node and npm")
    if not (WEB / "node_modules" / "esbuild").is_dir():
        done = subprocess.run(["npm", "ci"], cwd=WEB, capture_output=True)
        if done.returncode:
            pytest.skip("npm could not fetch the editor's packages")
    folder = tmp_path_factory.mktemp("editor")
    subprocess.run(["node", str(WEB / "bundle.mjs"), str(folder)], check=True)
    return folder / "editor.js"
