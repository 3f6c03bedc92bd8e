"""FaceScript: a small language for faces, and its compiler.

`load` and `loads` make a take of a script, `Script` writes one without text (docs/python.md).
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from facescript.api.script import Script
    from facescript.api.take import ScriptFault, Take, load, loads

__version__ = "0.1.0"

__all__ = ["Script", "ScriptFault", "Take", "load", "loads"]

_PLACES = {"Script": "script", "ScriptFault": "take", "Take": "take", "load": "take", "loads": "take"}


def __getattr__(name: str) -> Any:
    """What programs use is imported when it is asked for: the command line starts without it."""
    if name not in _PLACES:
        raise AttributeError(f"module 'facescript' has no attribute '{name}'")
    return getattr(import_module(f"facescript.api.{_PLACES[name]}"), name)
