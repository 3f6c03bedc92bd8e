"""What the server offers is what its features answer: neither more nor less."""

from __future__ import annotations

import subprocess
import sys
from importlib import import_module
from pathlib import Path

from pygls.lsp.server import LanguageServer

from facescript.lsp import features
from facescript.lsp.offered import OFFERED


class Listening(LanguageServer):
    """Notes which methods a feature answers."""

    def __init__(self) -> None:
        super().__init__("listening", "1")
        self.heard: list[tuple[str, str]] = []
        self.followers: list[object] = []

    def answers(self, feature: str) -> None:
        before = set(self.protocol.fm.features)
        import_module(f"facescript.lsp.features.{feature}").register(self)
        self.heard += [(method, feature) for method in set(self.protocol.fm.features) - before]


def test_every_feature_answers_what_is_offered() -> None:
    server = Listening()
    for path in sorted(Path(features.__path__[0]).glob("[a-z]*.py")):
        server.answers(path.stem)
    assert sorted(server.heard) == sorted((offer.method, offer.feature) for offer in OFFERED)


def test_the_compiler_is_not_loaded_before_an_editor_is_answered() -> None:
    script = "import sys; from facescript.lsp.server import make_server; make_server(); print('lark' in sys.modules)"
    assert (
        subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True).stdout == "False\n"
    )
