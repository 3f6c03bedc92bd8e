"""A soundtrack to an address that holds it: MP3 inside a `data:` URI."""

from __future__ import annotations

import base64

from facescript.backends.audio import mp3
from facescript.speech.sound.mix import Soundtrack


def sound_address(sound: Soundtrack) -> str | None:
    """The `data:` URI of a sound, or None where it is silent throughout. Raises `JobFailure`."""
    data = mp3(sound)
    return f"data:audio/mpeg;base64,{base64.b64encode(data).decode('ascii')}" if data else None
