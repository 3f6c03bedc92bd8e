"""A shape of the mouth in time, and what it asks of each of the mouth's axes."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.speech.mouth.visemes import SHAPES, Values

CLOSED = ("m", "f")
"""The shapes that are always reached: lips shut, and the lower lip on the teeth."""

AXES = {
    "lips": ("open", "upper", "lower", "teeth", "tongue"),
    "jaw": ("jaw",),
    "corners": ("wide", "round"),
}
"""What the mouth moves by itself, each with its parts (`channels.MOUTH`): on each axis at most two shapes weigh."""

FREE = {"lips": (), "jaw": ("h'", "h", "n"), "corners": ("m", "h'", "h", "n", "th", "z")}
"""The consonants that leave an axis to the vowels around them, where a language is written in IPA: the jaw goes through
what the tongue does alone, and lips are rounded through all that rounding does not disturb."""

WIDEST_JAW = 1.0
"""The jaw moves no further."""


@dataclass(frozen=True, slots=True)
class MouthShape:
    """A shape of `visemes.SHAPES`, or of an author (`own`), at a degree, fully there from `on` to `off` (seconds).

    Before `on` the mouth comes from the shape before, after `off` it goes to the next. Of a closure, `on` may come
    `slack` seconds later, beside another one `yields` later, and `off` `trim` earlier. `effort` is how far the jaw
    goes, 1 as usual. A `vowel` holds every axis; a consonant leaves some to it, unless it is `exact`.
    """

    name: str
    on: float
    off: float
    degree: float = 1.0
    slack: float = 0.0
    yields: float = 0.0
    trim: float = 0.0
    effort: float = 1.0
    vowel: bool = False
    exact: bool = False
    own: Values | None = None

    def later(self, seconds: float, limit: float) -> MouthShape:
        """The shape moved by `seconds`, no longer there at `limit`."""
        return self._timed(self.on + seconds, min(self.off + seconds, limit), self.slack, self.yields, self.trim)

    def begun(self, on: float) -> MouthShape:
        """The shape there from `on` at the earliest."""
        less = on - self.on
        return self._timed(on, max(self.off, on), self.slack - less, self.yields - less, self.trim)

    def ended(self, off: float) -> MouthShape:
        """The shape there up to `off`."""
        return self._timed(self.on, off, self.slack, self.yields, self.trim - (self.off - off))

    def _timed(self, on: float, off: float, slack: float, yields: float, trim: float) -> MouthShape:
        """The shape at another time. A line has hundreds: `dataclasses.replace` takes three times as long."""
        rest = self.effort, self.vowel, self.exact, self.own
        return MouthShape(self.name, on, off, self.degree, slack, yields, trim, *rest)

    @property
    def closed(self) -> bool:
        return self.name in CLOSED

    @property
    def rounded(self) -> bool:
        return self.values[2] > 0.0

    @property
    def values(self) -> Values:
        """The mouth's channels at its degree and effort. Teeth and tongue are places and have no degree; what the jaw
        moves further, it takes the lower lip along."""
        opened, wide, rounded, upper, lower, jaw, teeth, tongue = self.own or SHAPES[self.name]
        further = self.degree * self.effort
        sunk = lower * (further if lower > 0.0 else self.degree)
        gap = max(self.degree * opened + (sunk - self.degree * lower), 0.0)
        moved = min(further * jaw, WIDEST_JAW)
        return gap, self.degree * wide, self.degree * rounded, self.degree * upper, sunk, moved, teeth, tongue

    def holds(self, axis: str) -> bool:
        """Whether the axis comes to this shape, or passes it on its way from the one before to the next."""
        return self.vowel or self.exact or self.name not in FREE[axis]
