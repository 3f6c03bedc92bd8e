"""Skips what needs the synthesiser where its package is not installed; writes lines as files."""

from __future__ import annotations

import wave
from collections.abc import Callable
from pathlib import Path

import pytest

from facescript.speech.model import Spoken


@pytest.fixture(scope="session")
def synthesiser() -> None:
    pytest.importorskip("espeakng_loader", reason="the package espeakng-loader is not installed")


@pytest.fixture(scope="session")
def wav_of() -> Callable[[Spoken, Path], None]:
    """Writes a line as a WAV file."""

    def write(spoken: Spoken, path: Path) -> None:
        with wave.open(str(path), "wb") as file:
            file.setnchannels(1)
            file.setsampwidth(2)
            file.setframerate(spoken.rate)
            file.writeframes(spoken.pcm)

    return write
