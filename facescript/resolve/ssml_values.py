"""The attributes of SSML's tags to seconds, readings and factors."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from types import MappingProxyType

from facescript.speech.timing.alphabets import from_xsampa

STRENGTHS = {"none": 0.0, "x-weak": 0.1, "weak": 0.2, "medium": 0.4, "strong": 0.7, "x-strong": 1.2}
"""Seconds of a break by its strength."""

RATES = {"x-slow": 0.5, "slow": 0.75, "medium": 1.0, "default": 1.0, "fast": 1.25, "x-fast": 1.6}
PITCHES = {"x-low": 0.75, "low": 0.87, "medium": 1.0, "default": 1.0, "high": 1.15, "x-high": 1.3}
VOLUMES = {"silent": 0.0, "x-soft": 0.3, "soft": 0.6, "medium": 1.0, "default": 1.0, "loud": 1.3, "x-loud": 1.6}

LEAST, MOST = 0.1, 10.0
"""What a factor is kept within."""

_TIME = re.compile(r"\+?(\d{1,6}(?:\.\d{1,6})?)(ms|s)")
_NUMBER = re.compile(r"([-+]?)(\d{1,4}(?:\.\d{1,6})?)(%|st|dB)?")


def pause_of(values: Mapping[str, str]) -> float | None:
    """Seconds of a `<break>`; None where they cannot be read."""
    if "time" not in values:
        return STRENGTHS.get(values.get("strength", "medium"))
    found = _TIME.fullmatch(values["time"].strip())
    return float(found[1]) / (1000 if found[2] == "ms" else 1) if found else None


def reading_of(tag: str, values: Mapping[str, str], text: str) -> str:
    """The reading that a tag gives a text, as a script writes it; "" where it gives none."""
    if tag == "sub":
        return " ".join(values.get("alias", "").split())
    if tag == "say-as":
        spelt = values.get("interpret-as") in ("characters", "spell-out", "verbatim")
        return " ".join(sign for sign in text if not sign.isspace()) if spelt else ""
    sounds, alphabet = values.get("ph", "").strip(), values.get("alphabet", "ipa").lower()
    if alphabet in ("x-sampa", "xsampa"):
        sounds, alphabet = from_xsampa(sounds), "ipa"
    if not sounds or alphabet not in ("ipa", "pinyin", "x-pinyin"):
        return ""
    return f"/{sounds}/" if alphabet == "ipa" else sounds


def _factor(names: Mapping[str, float], value: str) -> float | None:
    """`slow`, `120%`, `+10%`, `1.2`; of a pitch `+2st`, of a volume `-6dB`."""
    value = value.strip()
    if value in names:
        return names[value]
    found = _NUMBER.fullmatch(value)
    if found is None:
        return None
    sign, number, unit = found[1], float(found[2]), found[3]
    signed = -number if sign == "-" else number
    if unit == "st":
        factor = 2 ** (signed / 12) if names is PITCHES else None
    elif unit == "dB":
        factor = 10 ** (signed / 20) if names is VOLUMES else None
    elif unit == "%":
        factor = (1 + signed / 100) if sign else number / 100
    else:
        factor = number if names is RATES and not sign else number / 100 if names is VOLUMES and not sign else None
    return None if factor is None else factor if factor == 0 and names is VOLUMES else min(max(factor, LEAST), MOST)


PROSODY: Mapping[str, Callable[[str], float | None]] = MappingProxyType(
    {
        "rate": lambda value: _factor(RATES, value),
        "pitch": lambda value: _factor(PITCHES, value),
        "volume": lambda value: _factor(VOLUMES, value),
    }
)

PROSODY_FORMS = {
    "rate": "`slow`, `120%` or `+20%`",
    "pitch": "`high`, `+10%` or `+2st`",
    "volume": "`loud`, `80%` or `-6dB`",
}
