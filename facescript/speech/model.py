"""What a spoken line is: sound, and when its words and phonemes are."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

from facescript.ir.acts import Say
from facescript.speech.spool import Kept


@dataclass(frozen=True, slots=True)
class WordTime:
    """A word of the line: its stretch of the plain text (characters), and seconds from the line's start; whether the
    text stresses it (`*word*`)."""

    text: str
    first: int
    last: int
    start: float
    end: float
    stress: bool = False


@dataclass(frozen=True, slots=True)
class PhoneTime:
    """A phoneme (IPA; "" is silence), or in Mandarin a syllable's mouth shape; seconds from the line's start.

    A plosive starts at its burst, its closure lies in what is before. A Mandarin shape is `zh:` and its name in the
    thesis's section 5.2.2 (`zh:a`, `zh:h'`): it is there at `start` and gives way from `end` on, where the next
    follows at once from `start` on; between shapes there may be time to move.
    """

    symbol: str
    start: float
    end: float
    stress: bool = False


@dataclass(frozen=True, slots=True)
class Doubt:
    """A warning about a line: the diagnostic's code, and the clause that it carries as its `reason`."""

    code: str
    reason: str


@dataclass(frozen=True, slots=True, weakref_slot=True)
class Spoken:
    """A line as sound: mono samples at `rate` Hz in memory or in a file, words, phones, seconds.

    `estimated` lines have times but no sound: no voice was started for them. `doubts` are what the author should know
    of a line that is spoken all the same; `marks` are named moments that a file of times has, in seconds.
    """

    sound: bytes | Kept
    rate: int
    duration: float
    words: tuple[WordTime, ...]
    phones: tuple[PhoneTime, ...]
    estimated: bool = False
    doubts: tuple[Doubt, ...] = ()
    marks: tuple[tuple[str, float], ...] = ()

    @property
    def pcm(self) -> bytes:
        """The samples, 16-bit little-endian; read from the file where they are kept in one."""
        return self.sound if isinstance(self.sound, bytes) else self.sound.read()


class VoiceBox(Protocol):
    """Turns lines into speech."""

    def speak(self, line: Say) -> Spoken:
        """The line spoken. Raises `VoiceFailure` where the voice does not exist or cannot run."""
        ...


class VoiceFailure(Exception):
    """A line that cannot be spoken; `args[0]` is a clause for the author, `code` the diagnostic that carries it as
    its `reason`: FS501 for a voice that does not exist or cannot run, others for faults of the text or of files."""

    def __init__(self, reason: str, code: str = "FS501") -> None:
        super().__init__(reason)
        self.code = code
