"""The set-ups of the manual's page on editors: Neovim's and Emacs's run with the real programs."""

from __future__ import annotations

import json
import os
import plistlib
import re
import shutil
import subprocess
import sys
import time
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from colours import CLIENT, ROOT
from websockets.sync.client import ClientConnection, connect

PAGE = (ROOT / "docs" / "editors.md").read_text("utf-8")
needs_neovim = pytest.mark.skipif(not shutil.which("nvim"), reason="needs Neovim: apt-get install neovim")

ACT = """
local wait = function(count)
  return vim.wait(20000, function() return #vim.diagnostic.get(0) == count end, 20)
end
local told = { wait(1), vim.bo.filetype }
for _, found in ipairs(vim.diagnostic.get(0)) do
  table.insert(told, { found.lnum, found.col, found.end_col, found.code, found.source })
end
vim.api.nvim_buf_set_text(0, 0, 7, 0, 9, { "il" })
table.insert(told, { wait(0), vim.api.nvim_buf_get_lines(0, 0, 1, true)[1] })
print(vim.json and vim.json.encode(told) or vim.fn.json_encode(told))
"""
"""What a user of Neovim does: opens a script with a slip, looks at what is told, and mends it."""


SHOW = """
local wait = function(holds) return vim.wait(60000, holds, 20) end
local line = function() return vim.api.nvim_buf_get_lines(0, 1, 2, true)[1] end
vim.lsp.handlers["window/showMessage"] = function(_, told)
  vim.fn.writefile({ told.message }, "address.part")
  os.rename("address.part", "address")
end
wait(function() return #vim.lsp.buf_get_clients(0) > 0 and vim.lsp.buf_get_clients(0)[1].initialized end)
vim.cmd("FacePreview")
local told = { wait(function() return line() ~= "wait 500ms" end), line() }
vim.cmd("undo")
table.insert(told, line())
print(vim.json and vim.json.encode(told) or vim.fn.json_encode(told))
"""
"""What a user of Neovim does with a preview: opens it, sees the line that is dragged there, and takes that back."""

EGLOT = """
(package-activate-all)
(require 'eglot)
(setq eglot-sync-connect 20)
(load (expand-file-name "init.el") nil t)
(find-file "a.face")
(run-hooks 'post-command-hook)
(with-timeout (20) (while (not (flymake-diagnostics)) (accept-process-output nil 0.05)))
(dolist (found (flymake-diagnostics))
  (princ (format "%S %d %d %s\\n" major-mode (flymake-diagnostic-beg found) (flymake-diagnostic-end found)
                 (flymake-diagnostic-text found))))
(end-of-line)
(princ (if (nth 4 (syntax-ppss)) "comment" "text"))
(princ (format "\\n%S" (commandp 'face-script-preview)))
"""
"""What a user of Emacs sees of a script with a slip."""


def emacs(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(["emacs", "--batch", *arguments], capture_output=True, text=True, timeout=60)


def no_eglot() -> bool:
    return (
        not shutil.which("emacs") or emacs("--eval", "(progn (package-activate-all) (require 'eglot))").returncode != 0
    )


def blocks(kind: str) -> list[str]:
    return re.findall(rf"^```{kind}\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder to work in, with `facescript` as a program on the path."""
    program = tmp_path / "bin" / "facescript"
    program.parent.mkdir()
    program.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m facescript.cli.main "$@"\n', "utf-8")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{program.parent}{os.pathsep}{os.environ['PATH']}")
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    return tmp_path


def neovim(*arguments: str) -> str:
    done = subprocess.run(["nvim", "--headless", "-n", *arguments, "-c", "qa!"], capture_output=True, timeout=60)
    assert done.returncode == 0
    return done.stderr.decode("utf-8").strip()


@needs_neovim
def test_neovim_shows_a_slip_and_sees_it_mended(here: Path) -> None:
    (here / "init.lua").write_text(blocks("lua")[2], "utf-8")
    (here / "act.lua").write_text(ACT, "utf-8")
    (here / "a.face").write_text("show smlie 60%  # \U0001f600\nnod\n", "utf-8")
    told = json.loads(neovim("-u", "init.lua", "a.face", "-c", "luafile act.lua"))
    assert told == [
        True,
        "face",
        [0, 5, 10, "FS201", "facescript"],
        [True, "show smile 60%  # \U0001f600"],
    ]


@needs_neovim
def test_neovim_takes_what_is_dragged_in_its_preview(here: Path) -> None:
    (here / "init.lua").write_text(blocks("lua")[2] + blocks("lua")[1], "utf-8")
    (here / "act.lua").write_text(SHOW, "utf-8")
    (here / "a.face").write_text("nod\nwait 500ms\nblink\n", "utf-8")
    words = ["nvim", "--headless", "-n", "-u", "init.lua", "a.face", "-c", "luafile act.lua", "-c", "qa!"]
    with subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as running:
        address = wait_for(here / "address").removeprefix("The preview is at ")
        with connect(f"{address.partition('?')[0].replace('http', 'ws')}live", max_size=None) as page:
            score = next(one for one in said(page) if one["kind"] == "score")
            (blink,) = (number for number, act in enumerate(score["acts"]) if act["label"] == "blink")
            drag = {"version": score["version"], "id": blink, "handle": "body", "by": 0.3, "degree": None, "done": True}
            page.send(json.dumps({"kind": "drag", **drag}))
            told = running.communicate(timeout=60)[1].decode("utf-8").strip()
    assert json.loads(told.splitlines()[-1]) == [True, "wait 800ms", "wait 500ms"]


def wait_for(place: Path) -> str:
    """The text of a file, once it is there."""
    for _ in range(1200):
        if place.exists() and (text := place.read_text("utf-8")):
            return text
        time.sleep(0.05)
    raise AssertionError(f"{place.name} never came")


def said(page: ClientConnection) -> Iterator[dict[str, Any]]:
    """What a page is told in JSON."""
    while True:
        message = page.recv(timeout=60)
        if isinstance(message, str):
            yield json.loads(message)


@needs_neovim
def test_all_of_neovims_are_lua(here: Path) -> None:
    for block in blocks("lua"):
        (here / "block.lua").write_text(block, "utf-8")
        assert neovim("-u", "NONE", "-c", "lua assert(loadfile('block.lua')); print('read')") == "read"


@pytest.mark.skipif(not shutil.which("emacs"), reason="needs Emacs: apt-get install emacs-nox elpa-eglot")
def test_emacs_shows_a_slip(here: Path) -> None:
    (here / "init.el").write_text("".join(blocks("elisp")), "utf-8")
    (here / "act.el").write_text(EGLOT, "utf-8")
    (here / "a.face").write_text("show smlie 60%  # done\nnod\n", "utf-8")
    done = emacs("-l", "act.el")
    if "Cannot open load file" in done.stderr and "eglot" in done.stderr:
        pytest.skip("this Emacs has no eglot: apt-get install elpa-eglot")
    told = done.stdout.splitlines()
    assert told[0].startswith("face-script-mode 6 11 facescript [FS201]: `smlie`") and told[1:] == ["comment", "t"]


def test_the_other_set_ups_can_be_read() -> None:
    read = [tomllib.loads(block) for block in blocks("toml")] + [json.loads(block) for block in blocks("json")]
    servers = [block["language-server"]["facescript"] for block in read if "language-server" in block]
    assert servers == [{"command": "facescript", "args": ["lsp"]}]
    clients = [block["clients"]["facescript"]["command"] for block in read if "clients" in block]
    assert clients == [["facescript", "lsp"]]


def test_sublime_is_given_the_grammar_as_it_reads_them(tmp_path: Path) -> None:
    (line,) = (line for line in PAGE.splitlines() if line.startswith("python3 -c"))
    code = re.findall(r'-c "(.*)" <', line)[0]
    grammar = CLIENT / "syntaxes" / "face.tmLanguage.json"
    done = subprocess.run([sys.executable, "-c", code], input=grammar.read_bytes(), capture_output=True, check=True)
    assert plistlib.loads(done.stdout) == json.loads(grammar.read_text("utf-8"))
