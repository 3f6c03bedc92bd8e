"""What a play does: one class a verb, and the blocks that order them in time."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from facescript.ir.values import Aim, Amount, AtCamera, Mix, Moment
from facescript.text import Span

Manner = Literal["", "posed", "spontaneous"]
"""How an expression comes and goes: made on purpose, or felt; "" is neither."""


@dataclass(frozen=True, slots=True)
class Timing:
    """`over T for T back in T ease NAME, MANNER`; None is the verb's own default, and that of its manner."""

    over: Amount | None = None
    lasting: Amount | None = None
    back: Amount | None = None
    ease: str | None = None
    manner: Manner = ""


GazeParts = Literal["eyes then head", "head then eyes", "eyes only", "head only"]


@dataclass(frozen=True, slots=True)
class GazeManner:
    """How the parts take part in a look: `head_share` is `head 40%`, `speed` scales both, `latency` is a delay."""

    parts: GazeParts = "eyes then head"
    head_share: Amount | None = None
    speed: Amount = 1.0
    latency: Amount = 0.0


@dataclass(frozen=True, slots=True)
class Look:
    aim: Aim
    manner: GazeManner = GazeManner()
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Glance:
    """There and back; `timing.lasting` is half a second unless said."""

    aim: Aim
    manner: GazeManner = GazeManner()
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Scan:
    """Fixate each of a crowd (`crowd` is a target's name or "people"), `dwell` seconds each (None: as people do)."""

    crowd: str
    dwell: Amount | None = None
    order: Literal["in order", "nearest first", "at random"] = "in order"
    manner: GazeManner = GazeManner()


@dataclass(frozen=True, slots=True)
class Show:
    """The base expression becomes `mix`."""

    mix: Mix
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Add:
    """`mix` is laid on top until it is dropped, or for `timing.lasting`."""

    mix: Mix
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Drop:
    """Whatever bears `name` (a term of a show or add, or a statement's label) lets go."""

    name: str
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Gesture:
    """A movement that comes back by itself; `mix` is its pose at the far point, `timing.lasting` its length."""

    kind: Literal["nod", "shake", "tilt", "blink", "wink"]
    degree: Amount
    mix: Mix
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Voice:
    """How a line sounds: `language` as espeak-ng names it, and factors of 1, `range` how far the melody swings.

    `variant` is female, male or a variant of espeak-ng; of another `engine`, its voice's name or its file in the
    project.
    """

    language: str = "en-us"
    variant: str = ""
    rate: float = 1.0
    pitch: float = 1.0
    volume: float = 1.0
    range: float = 1.0
    engine: str = "espeak"


@dataclass(frozen=True, slots=True)
class Cue:
    """A statement started inside a line: at the `nth` word that is `word` (an `on`), or before the character `at` of
    the line's plain text (an inline cue), which ends at the character `until` if that is not None."""

    body: Block
    word: str | None = None
    nth: int = 1
    at: int | None = None
    until: int | None = None


@dataclass(frozen=True, slots=True)
class Stretch:
    """Something said of a stretch of the plain text: `kind` is "stress", "breath", "pause", "reading" or "mark".

    `value` is a pause's seconds as text, a reading as written, or the name of a mark; a breath, a pause and a mark have
    start == end.
    """

    kind: Literal["stress", "breath", "pause", "reading", "mark"]
    start: int
    end: int
    value: str = ""


@dataclass(frozen=True, slots=True)
class Say:
    """A line: its text without marks, the marks, the voice, and what happens on its words.

    `recording` is a sound file of the project that is heard instead of the voice (then `text` may be empty), `times` a
    file that says when its words are.
    """

    text: str
    voice: Voice
    stretches: tuple[Stretch, ...] = ()
    cues: tuple[Cue, ...] = ()
    recording: str | None = None
    times: str | None = None


@dataclass(frozen=True, slots=True)
class Take:
    """A recorded performance of one face, read from the file `path` of the project.

    `kind` says whose `columns` they are: shapes of ARKit, parameters of MPEG-4 (FAP), or channels. `data` are
    `frames` rows of the time (s, the first 0) and each column: 32 bit floats, little-endian, in base64. It lasts
    `duration` seconds.
    """

    path: str
    kind: Literal["arkit", "fap", "channels"]
    columns: tuple[str, ...]
    frames: int
    duration: float
    data: str


@dataclass(frozen=True, slots=True)
class Perform:
    """A take is played, at `speed` times the rate of its recording, for `timing.lasting` seconds at most."""

    take: Take
    speed: Amount = 1.0
    timing: Timing = Timing()


@dataclass(frozen=True, slots=True)
class Wait:
    duration: Amount


@dataclass(frozen=True, slots=True)
class WaitUntil:
    moment: Moment


@dataclass(frozen=True, slots=True)
class Gradient:
    """Two or more colours `#rrggbb[aa]`, at even steps in a direction (deg, 0 to the viewer's right, 90 up), or from
    the picture's middle to its corners (None)."""

    colours: tuple[str, ...]
    towards: float | None


@dataclass(frozen=True, slots=True)
class SetBackground:
    """The picture behind: a colour `#rrggbb[aa]`, a picture's path inside the project, or a gradient; transparent
    where it is none of them."""

    colour: str | None
    picture: str | None
    over: Amount = 0.0
    gradient: Gradient | None = None


@dataclass(frozen=True, slots=True)
class View:
    """The camera: on `face` (None: all) at `zoom`, over `over` seconds."""

    face: str | None
    zoom: Amount = 1.0
    over: Amount = 0.0


@dataclass(frozen=True, slots=True)
class Life:
    """What a living face does unasked. Knobs by name in base units (`blink` 1/min, `sway` 1, `saccades` 1/min,
    `avert` 1, `brows` 1/min, `nods` 1); `name` is the preset it grew from, `announcer` has its own statistics."""

    name: str
    knobs: tuple[tuple[str, Amount], ...] = ()


@dataclass(frozen=True, slots=True)
class SetLife:
    life: Life
    over: Amount = 0.0


@dataclass(frozen=True, slots=True)
class SetPicture:
    """The picture beside the face in a book: its path inside the project, None for none; `caption` is also said in
    its place."""

    picture: str | None
    caption: str = ""


@dataclass(frozen=True, slots=True)
class AddLink:
    """A link beside the face in a book from here to the scene's end: an http, https or mailto address, and its text."""

    address: str
    text: str


Verb = (
    Look
    | Glance
    | Scan
    | Show
    | Add
    | Drop
    | Gesture
    | Say
    | Perform
    | Wait
    | WaitUntil
    | SetBackground
    | View
    | SetLife
    | SetPicture
    | AddLink
)

# ------------------------------------------------------------------------------------------------ blocks


@dataclass(frozen=True, slots=True)
class Do:
    """One act of one face (None: of the scene), with the label an author gave it.

    A label is a full name, and a `Mark` bears the same string: `opening.hello` in the scene `opening`, `hello` in a
    script without scenes, `trials.7.cued` in the seventh pass of the scene's `repeat NAME in ...` (of its second such
    `repeat`: `trials.repeat2.7.cued`), `opening.greet.2.bow` in the second call of the action `greet` there,
    `when.3.bye` in the third reaction. In the body of a `Repeat` a `*` stands for the pass's number (`opening.*.cued`),
    one for each `Repeat` around it, outermost first; `in_pass` fills them.
    """

    verb: Verb
    face: str | None
    label: str | None
    span: Span


@dataclass(frozen=True, slots=True)
class Sequence:
    """One after another; times count from its start where `clock` is set (a scene, an action, a pass of a repeat)."""

    items: tuple[Node, ...]
    span: Span
    clock: bool = False
    label: str | None = None


@dataclass(frozen=True, slots=True)
class Together:
    items: tuple[Node, ...]
    span: Span
    label: str | None = None


@dataclass(frozen=True, slots=True)
class Choose:
    """One of its items, by the seed."""

    items: tuple[Node, ...]
    span: Span
    label: str | None = None


@dataclass(frozen=True, slots=True)
class Repeat:
    """`body` again and again: `times` passes, or for `lasting` seconds, or for ever (both None)."""

    body: Sequence
    times: int | None
    lasting: Amount | None
    span: Span
    label: str | None = None


@dataclass(frozen=True, slots=True)
class At:
    """`body` at a moment, beside the sequence it stands in."""

    moment: Moment
    body: Block
    span: Span
    label: str | None = None


def in_pass(label: str, passes: tuple[int, ...]) -> str:
    """A label or a mark's label with the numbers (from 1) of the `Repeat` passes around it, outermost first."""
    for number in passes:
        label = label.replace("*", str(number), 1)
    return label


Node = Do | Sequence | Together | Choose | Repeat | At
Block = Sequence


CAMERA = AtCamera()
