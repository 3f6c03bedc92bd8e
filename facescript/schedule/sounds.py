"""Lines as they were spoken to the sounds in them that no mouth shape is known for, each told once."""

from __future__ import annotations

from collections.abc import Iterable

from facescript.ir.play import Viseme
from facescript.schedule.deeds import Sounding
from facescript.schedule.faults import Faults
from facescript.schedule.voices import Voices
from facescript.speech.mouth.own import table_of


def sounds_unknown(sounds: Iterable[Sounding], voices: Voices, visemes: Iterable[Viseme], faults: Faults) -> None:
    """A hint for each sign that is neither in the table nor among an author's `visemes`, at the first line with it."""
    table, told = table_of(visemes), set[str]()
    for sounding in sounds:
        span = sounding.step.node.span
        symbols = {phone.symbol for phone in voices.speak(sounding.line, span).phones if phone.symbol}
        for sign in sorted({sign for symbol in symbols for sign in table.unknown(symbol)} - told):
            told.add(sign)
            faults.add("FS525", span, once=sign, sound=sign)
