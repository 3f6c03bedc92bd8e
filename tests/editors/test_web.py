"""The editor of the preview's page: the colours of VS Code, by the same grammar, from packages that are locked."""

from __future__ import annotations

import json
import re
import shutil
import subprocess

import pytest
from colours import ROOT, SCRIPTS, golden, page

from facescript import __version__

WEB = ROOT / "editors" / "web"
PACKAGE = json.loads((WEB / "package.json").read_text("utf-8"))
LOCK = json.loads((WEB / "package-lock.json").read_text("utf-8"))
BRACKETS = re.compile(r"^ {8}\] {21}(?P<scopes>.*)\n {8}\[ {21}(?P=scopes)$", re.MULTILINE)


@pytest.mark.skipif(shutil.which("node") is None, reason="needs node")
def test_scripts_have_the_colours_of_vscode() -> None:
    command = ["node", str(WEB / "tokens.mjs"), *map(str, SCRIPTS)]
    done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8", check=True)
    for script, lines in zip(SCRIPTS, json.loads(done.stdout), strict=True):
        golden_page = BRACKETS.sub(rf"        {'][':20}  \g<scopes>", golden(script).read_text("utf-8"))
        assert page(script, lines) == golden_page, script.name


def test_versions_agree() -> None:
    assert PACKAGE["version"] == LOCK["version"] == LOCK["packages"][""]["version"] == __version__
    assert PACKAGE["devDependencies"] == LOCK["packages"][""]["devDependencies"]


def test_lock_file_names_no_registry() -> None:
    assert "resolved" not in (WEB / "package-lock.json").read_text("utf-8")
    assert [name for name, found in LOCK["packages"].items() if name and "integrity" not in found] == []
