"""What a program tells a face that is running: say this, look there, be still."""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from facescript.live.talk.client import Refusal, connect, connect_plain

__all__ = ["Refusal", "connect", "connect_plain"]


def __getattr__(name: str) -> Any:
    """What programs use is imported when it is asked for."""
    if name not in __all__:
        raise AttributeError(f"module 'facescript.live.talk' has no attribute '{name}'")
    return getattr(import_module("facescript.live.talk.client"), name)
