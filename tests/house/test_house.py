"""The house rules that a machine can check: sizes of files and functions, first lines, no pickle, no copied names."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
MODULES = sorted((ROOT / "facescript").rglob("*.py"))
LONGEST_FILE = 400
LONGEST_FUNCTION = 60


def functions(tree: ast.Module) -> list[ast.FunctionDef]:
    return [node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]


@pytest.mark.parametrize("path", MODULES, ids=lambda path: str(path.relative_to(ROOT)))
def test_module_is_small_and_says_what_it_does(path: Path) -> None:
    text = path.read_text("utf-8")
    tree = ast.parse(text)
    assert text.count("\n") <= LONGEST_FILE, "split the file"
    assert ast.get_docstring(tree), "the first line says what the module turns into what"
    long = [f"{node.name} ({node.end_lineno - node.lineno + 1})" for node in functions(tree)
            if node.end_lineno is not None and node.end_lineno - node.lineno + 1 > LONGEST_FUNCTION]  # fmt: skip
    assert not long, f"split {long}"


def test_functions_are_mostly_short() -> None:
    lengths = sorted(
        node.end_lineno - node.lineno + 1
        for path in MODULES
        for node in functions(ast.parse(path.read_text("utf-8")))
        if node.end_lineno is not None
    )
    assert lengths[len(lengths) // 2] <= 12
    assert lengths[len(lengths) * 9 // 10] <= 35


def test_nothing_is_unpickled() -> None:
    for path in MODULES:
        imported = {
            alias.name.split(".")[0]
            for node in ast.walk(ast.parse(path.read_text("utf-8")))
            if isinstance(node, ast.Import | ast.ImportFrom)
            for alias in ([ast.alias(node.module or "")] if isinstance(node, ast.ImportFrom) else node.names)
        }
        assert not imported & {"pickle", "marshal", "shelve", "dill"}, path


def test_only_the_espeak_worker_is_under_another_licence() -> None:
    named = [str(path.relative_to(ROOT)) for path in MODULES if "GPL-3.0" in path.read_text("utf-8")]
    assert named == ["facescript/speech/espeak/worker.py"]
