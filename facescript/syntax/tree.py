"""The tree of a script: words in phrases, phrases in lines, lines in blocks; what words mean is resolve's business."""

from __future__ import annotations

from dataclasses import dataclass

from facescript.text import Source, Span

# ------------------------------------------------------------------------------------------------ words


@dataclass(frozen=True, slots=True)
class Name:
    """`smile`, `look`, `in-out`: a name or a word of the language."""

    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Dotted:
    """`smile.left`, `crowd.2`, `hello."cup".2.end`: parts are str for names and quoted words, int for numbers."""

    parts: tuple[str | int, ...]
    quoted: tuple[bool, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class String:
    """A text, its escapes still in place (`value` is what stands between the quotes)."""

    value: str
    span: Span


@dataclass(frozen=True, slots=True)
class Quantity:
    """`300ms`, `-12cm`, `80%`, `17/min`, `30fps`. `unit` is as written (`/min`); `value` is the number before it.

    A bare number with a decimal point is one too, its unit empty."""

    value: float
    unit: str
    span: Span


@dataclass(frozen=True, slots=True)
class Integer:
    """A bare number: a count."""

    value: int
    span: Span


@dataclass(frozen=True, slots=True)
class Size:
    """`1280x720`."""

    width: int
    height: int
    span: Span


@dataclass(frozen=True, slots=True)
class Colour:
    """`#rrggbb` or `#rrggbbaa`, as written."""

    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Operator:
    """`+ - * /` between words."""

    text: str
    span: Span


@dataclass(frozen=True, slots=True)
class Argument:
    """One argument of a call, `lift = 60%` or `60%`."""

    name: Name | None
    value: Phrase
    span: Span


@dataclass(frozen=True, slots=True)
class Call:
    """`crooked(lift = 60%)`: a name whose bracket touches it."""

    name: Name
    arguments: tuple[Argument, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Bracket:
    """`(lift / 2)`: a sum in brackets."""

    inner: Phrase
    span: Span


@dataclass(frozen=True, slots=True)
class Point:
    """`(-60cm 0cm 2m)`: two or three quantities in brackets."""

    coordinates: tuple[Quantity, ...]
    span: Span


Word = Name | Dotted | String | Quantity | Integer | Size | Colour | Operator | Call | Bracket | Point


@dataclass(frozen=True, slots=True)
class Phrase:
    """Words up to a comma or the end of the line."""

    words: tuple[Word, ...]
    span: Span


# ------------------------------------------------------------------------------------------------ statements


@dataclass(frozen=True, slots=True)
class On:
    """`on "word".2: ...` under a line."""

    word: String
    nth: int
    body: tuple[Statement, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Act:
    """A line that does something: phrases, and under a `say` further strings and `on` blocks."""

    phrases: tuple[Phrase, ...]
    more: tuple[String, ...]
    ons: tuple[On, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Cast:
    """`ada: ...`: what stands after the colon is done by this face."""

    face: Name
    body: tuple[Statement, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Group:
    """`together:`, `in turn:`, `choose:`; `kind` is that word."""

    kind: str
    body: tuple[Statement, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Repeat:
    """`repeat HOW: ...`; `how` are the words after `repeat`."""

    how: Phrase
    body: tuple[Statement, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Moment:
    """`at TIME: ...`."""

    time: Phrase
    body: tuple[Statement, ...]
    span: Span


Statement = Act | Cast | Group | Repeat | Moment

# ------------------------------------------------------------------------------------------------ definitions


@dataclass(frozen=True, slots=True)
class Parameter:
    """`lift = 40%` in the head of an expression or an action."""

    name: Name
    default: Phrase | None
    span: Span


@dataclass(frozen=True, slots=True)
class ExpressionDefinition:
    name: Name
    parameters: tuple[Parameter, ...]
    value: Phrase
    span: Span


@dataclass(frozen=True, slots=True)
class ActionDefinition:
    name: Name
    parameters: tuple[Parameter, ...]
    body: tuple[Statement, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class LetDefinition:
    name: Name
    value: Phrase
    span: Span


@dataclass(frozen=True, slots=True)
class VisemeDefinition:
    """`viseme "SOUND" = SUM` or `= "SOUND" 80%`."""

    sound: String
    value: Phrase
    span: Span


@dataclass(frozen=True, slots=True)
class Declaration:
    """`face NAME = phrases`, `life NAME = phrases`, `target NAME phrases`, with the indented lines below them."""

    kind: str
    name: Name
    phrases: tuple[Phrase, ...]
    lines: tuple[tuple[Phrase, ...], ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Setting:
    """`film phrases` or `event phrases`; `kind` is that word."""

    kind: str
    phrases: tuple[Phrase, ...]
    span: Span


@dataclass(frozen=True, slots=True)
class Use:
    path: String
    span: Span


@dataclass(frozen=True, slots=True)
class Scene:
    """`scene NAME ["TITLE"] [with FACE, FACE]: ...`."""

    name: Name
    faces: tuple[Name, ...]
    body: tuple[Statement, ...]
    span: Span
    title: String | None = None


@dataclass(frozen=True, slots=True)
class When:
    """`when EVENT: ...`; `event` are the words after `when`."""

    event: Phrase
    body: tuple[Statement, ...]
    span: Span


Definition = (
    ExpressionDefinition
    | ActionDefinition
    | LetDefinition
    | VisemeDefinition
    | Declaration
    | Setting
    | Use
    | Scene
    | When
)
Item = Definition | Statement


@dataclass(frozen=True, slots=True)
class Script:
    """A whole file: its items in the order written. `lost` are the names in lines that could not be read: what is said
    of these names elsewhere may be the fault of those lines."""

    source: Source
    items: tuple[Item, ...]
    lost: frozenset[str] = frozenset()
