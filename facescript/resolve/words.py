"""The language's words: a row for each verb and each modifier, which drive reading, messages and completion."""

from __future__ import annotations

import re
from dataclasses import dataclass

VALUE = "_"
"""Stands in a pattern for the words of a value."""


@dataclass(frozen=True, slots=True)
class Modifier:
    """How something is said more closely.

    `pattern` are its words, `VALUE` where its value stands; `takes` is the value's kind ("" for none); modifiers of
    one `group` exclude each other; `direct` ones follow without a comma.
    """

    name: str
    pattern: tuple[str, ...]
    takes: str
    help: str
    group: str = ""
    direct: bool = False

    @property
    def form(self) -> str:
        """As an author writes it: `over TIME`."""
        return " ".join(self.takes.upper().replace(" ", "-") if word == VALUE else word for word in self.pattern)


@dataclass(frozen=True, slots=True)
class Verb:
    """What a face does: how it is written, which modifiers it takes, what holds when they are not written."""

    name: str
    form: str
    modifiers: tuple[str, ...]
    default: str
    help: str


@dataclass(frozen=True, slots=True)
class Opener:
    """What begins a line that is no verb's: how the line is written, and what it does."""

    name: str
    form: str
    help: str


def _rows(*rows: Modifier) -> dict[str, Modifier]:
    return {row.name: row for row in rows}


def _valued(name: str, takes: str, help: str) -> Modifier:
    return Modifier(name, (name, VALUE), takes, help)


def _fixed(words: str, group: str, help: str) -> Modifier:
    return Modifier(words, tuple(words.split()), "", help, group)


MODIFIERS: dict[str, Modifier] = _rows(
    Modifier("over", ("over", VALUE), "time", "how long the change takes", direct=True),
    Modifier("for", ("for", VALUE), "time", "how long it lasts from its start; then it lets go", direct=True),
    Modifier("back", ("back", "in", VALUE), "time", "how long letting go takes", direct=True),
    Modifier("ease", ("ease", VALUE), "ease", "the curve: linear, smooth, in, out, in-out", direct=True),
    Modifier("from", ("from", VALUE), "file", "a recording to speak with", direct=True),
    Modifier("timed", ("timed", VALUE), "file", "the times of the words, as a file gives them", direct=True),
    Modifier("as", ("as", VALUE), "name", "names the statement; the name is a marker in the outputs", direct=True),
    _fixed("eyes then head", "parts", "the head follows the eyes"),
    _fixed("head then eyes", "parts", "the eyes follow the head"),
    _fixed("eyes only", "parts", "the head stays"),
    _fixed("head only", "parts", "the eyes stay straight in the head"),
    Modifier("head", ("head", VALUE), "percentage", "how much of the way the head goes"),
    _valued("speed", "percentage", "how fast eyes and head move, or a recorded face is played"),
    _valued("latency", "time", "how long after its time the look begins"),
    Modifier("each", (VALUE, "each"), "time", "how long each of the crowd is looked at"),
    _fixed("in order", "order", "the crowd as it is written"),
    _fixed("nearest first", "order", "each time the nearest of those left"),
    _fixed("at random", "order", "in an order the seed decides"),
    _fixed("posed", "manner", "it comes and goes quickly, as one made on purpose"),
    _fixed("spontaneous", "manner", "it comes slowly, stays smaller, lives and lingers, as one that is felt"),
    _valued("rate", "percentage", "how fast the voice speaks"),
    _valued("pitch", "percentage", "how high the voice speaks"),
    _valued("range", "percentage", "how far the voice's melody rises and falls"),
    _valued("volume", "percentage", "how loud the voice speaks"),
    _valued("blink", "rate", "blinks a minute"),
    _valued("brows", "rate", "brow raises a minute"),
    _valued("sway", "percentage", "how far the head moves by itself"),
    _valued("nods", "percentage", "how deep the head nods before pauses of its speech"),
    _valued("saccades", "rate", "idle saccades a minute"),
    _valued("avert", "percentage", "how far the eyes turn away at times: 100% is 30 degrees"),
    _fixed("top to bottom", "course", "the first colour above, the last below"),
    _fixed("left to right", "course", "the first colour at the viewer's left, the last at the right"),
    Modifier("towards", ("towards", VALUE), "angle", "where the last colour is: 0deg is right, 90deg up", "course"),
    _fixed("round", "course", "the first colour in the middle, the last in the corners"),
)

GAZE = ("eyes then head", "head then eyes", "eyes only", "head only", "head", "speed", "latency")
KNOBS = ("blink", "brows", "sway", "nods", "saccades", "avert")
CHANGE = ("over", "for", "back", "ease", "as")
MANNERS = ("posed", "spontaneous")
LASTING = ("over", "for", "as")
COURSES = ("top to bottom", "left to right", "towards", "round")
NOTHING = "none"
VOICE = ("rate", "pitch", "range", "volume")


def _verbs(*rows: Verb) -> dict[str, Verb]:
    return {row.name: row for row in rows}


VERBS: dict[str, Verb] = _verbs(
    Verb("look", "look at TARGET", (*GAZE, *LASTING), "eyes then head", "turns the gaze to a target and stays on it"),
    Verb("glance", "glance TARGET", (*GAZE, *LASTING), "for 500ms", "looks there and back"),
    Verb(
        "scan",
        "scan CROWD, TIME each",
        ("each", "in order", "nearest first", "at random", *GAZE, "as"),
        "in order, each as long as people do",
        "fixates each of a crowd",
    ),
    Verb("show", "show SUM", (*CHANGE, *MANNERS), "until the next `show`", "makes a sum the face's base expression"),
    Verb("add", "add SUM", (*CHANGE, *MANNERS), "until `drop`", "lays a sum on top of what is shown"),
    Verb("drop", "drop NAME", ("over", "ease", "as"), "", "lets go of an expression or of a named statement"),
    Verb("nod", "nod PERCENTAGE", ("for", "as"), "100%", "nods the head"),
    Verb("shake", "shake PERCENTAGE", ("for", "as"), "100%", "shakes the head"),
    Verb("tilt", "tilt left|right PERCENTAGE", ("for", "as"), "100%", "tilts the head to its own left or right"),
    Verb("blink", "blink PERCENTAGE", ("for", "as"), "100%", "blinks once"),
    Verb("wink", "wink left|right PERCENTAGE", ("for", "as"), "100%", "winks with its own left or right eye"),
    Verb("say", 'say "TEXT"', (*VOICE, "from", "timed", "as"), "the face's voice", "speaks a text"),
    Verb("play", 'play "FILE"', ("for", "speed", "as"), "to the file's end", "performs a recorded face"),
    Verb("wait", "wait TIME", ("as",), "", "lets time pass; `wait until TIME` waits for a moment"),
    Verb(
        "background",
        'background COLOUR [to COLOUR]|"PICTURE"|none',
        (*COURSES, "over", "as"),
        "top to bottom, over 0ms",
        "sets what is behind the faces",
    ),
    Verb("view", "view FACE PERCENTAGE|all", ("over", "as"), "all, over 0ms", "moves the camera to a face, or to all"),
    Verb(
        "picture",
        'picture "PICTURE" "CAPTION"|none',
        ("as",),
        "until the next `picture`",
        "shows a picture beside the faces, in books",
    ),
    Verb("link", 'link "ADDRESS" "TEXT"', ("as",), "until the scene's end", "shows a link beside the faces, in books"),
    Verb("life", "life PRESET", (*KNOBS, "over", "as"), "over 0ms", "sets what the face does unasked"),
)

VOICED = _rows(
    Modifier(
        "voice",
        ("voice", VALUE),
        "voice",
        "the language, and `female`, `male`, a variant's name, or an engine and its voice",
    ),
    *(MODIFIERS[name] for name in VOICE),
)

FACE: dict[str, Modifier] = {
    **VOICED,
    **_rows(
        _valued("life", "life", "what it does unasked; knobs follow after commas"),
        *(MODIFIERS[name] for name in KNOBS),
        _valued("size", "percentage", "how large it is drawn"),
        _valued("at", "place", "where its middle is, in percent of the picture from the picture's centre"),
        _valued("gaze", "gaze", "`eye-mover` or `head-mover`"),
        *(
            _valued(look, "look", f"the colour of its {look}, by name or `#rrggbb`")
            for look in ("skin", "eyes", "lips", "scarf")
        ),
        *(_valued(look, "look", f"the kind of its {look}, and its colour") for look in ("clothes", "beard")),
        _valued("hair", "look", "the cut of its hair and its colour; `still` where it does not move with the head"),
        *(
            _valued(look, "look", f"which {look} it has, and their colour")
            for look in ("eyebrows", "glasses", "earrings")
        ),
        _valued("age", "percentage", "how old it looks"),
        _valued("width", "percentage", "how wide its face is: 50% is as drawn"),
        _valued("make-up", "percentage", "how much make-up it wears"),
        _valued("freckles", "percentage", "how many freckles it has"),
        _valued("seed", "count", "draws all looks that are not written"),
    ),
}
"""What a face's definition may say after its kind, on its line or below."""

FILM: dict[str, Modifier] = _rows(
    Modifier("size", (VALUE,), "size", "width x height in pixels: `1280x720`"),
    Modifier("rate", (VALUE,), "frame rate", "pictures a second: `30fps`"),
    _valued("seed", "count", "decides every draw"),
    Modifier("long", (VALUE, "long"), "time", "a build ends there"),
    _valued("screen", "screen", "`patent`, `measured`, `none` or a percentage: how far gaze at near targets turns"),
    Modifier("wide", (VALUE, "wide"), "length", "the picture's physical width"),
    _valued("title", "text", "the title of pages and books"),
    _valued("author", "text", "who wrote the book"),
)

EASES = ("linear", "smooth", "in", "out", "in-out")
USUAL, UNSEEN = "woman", "unseen"
"""The kind of a face of which nothing is said, and that of one which is only heard."""

PARTS = ("eyes", "mouth")
DIRECTIONS = ("left", "right", "up", "down")

DIRECT = frozenset(row.pattern[0] for row in MODIFIERS.values() if row.direct)

SYNONYMS = {
    "follow": "look at",
    "track": "look at",
    "watch": "look at",
    "gaze": "look at",
    "face": "look at",
    "turn": "look at",
    "peek": "glance",
    "speak": "say",
    "talk": "say",
    "tell": "say",
    "pause": "wait",
    "sleep": "wait",
    "express": "show",
    "set": "show",
    "remove": "drop",
    "clear": "drop",
    "stop": "drop",
    "loop": "repeat",
    "camera": "view",
    "zoom": "view",
    "keep": "show",
}
"""Words of other languages, and what this one says instead."""


def _openers(*rows: Opener) -> dict[str, Opener]:
    return {row.name: row for row in rows}


BLOCKS: dict[str, Opener] = _openers(
    Opener("together", "together:", "starts all its statements at once, and settles with the last"),
    Opener("in turn", "in turn:", "makes several statements one: one after another"),
    Opener("choose", "choose:", "does one of its statements, by the seed"),
    Opener(
        "repeat", "repeat 3 times:", 'passes: `3 times`, `for 20s`, `forever`, `NAME in CROWD` or `NAME in "TABLE"`'
    ),
    Opener("at", "at TIME:", "does its statements at a moment, and does not move the sequence on"),
    Opener("on", 'on "WORD":', "does its statements when the word of the line above is spoken"),
)
"""What holds statements, where statements stand."""

ENDINGS: dict[str, Opener] = _openers(
    Opener("resume", "resume", "the last word of a reaction: the scene goes on"),
    Opener("restart", "restart", "the last word of a reaction: the scene begins again"),
    Opener("stop", "stop", "the last word of a reaction: the scene ends, and the next begins"),
)

DEFINITIONS: dict[str, Opener] = _openers(
    Opener("film", "film 1280x720, 30fps, seed 7", "what the outputs are like"),
    Opener("use", 'use "FILE"', "the definitions of another script"),
    Opener("face", "face NAME = KIND, voice VOICE", "a face: its kind, voice, life and looks, here or on lines below"),
    Opener("target", "target NAME at PLACE", "a place to look at; `moves` or `from` a file, or a crowd `of` places"),
    Opener("expression", "expression NAME = SUM", "a sum of muscles, units and expressions, with parameters if wanted"),
    Opener("action", "action NAME(PARAMETER, PARAMETER = VALUE):", "a verb of the script's own"),
    Opener("let", "let NAME = VALUE", "a value with a name: a quantity, a draw, a sum, a colour, a text"),
    Opener("life", "life NAME = PRESET, blink 8/min", "what a face does unasked"),
    Opener("scene", 'scene NAME "TITLE" with FACE, FACE:', "statements that begin afresh; scenes play in their order"),
    Opener("when", 'when heard "WORD":', "a reaction: runs beside the scene when something happens"),
    Opener("event", 'event heard "WORD" at TIME', "what happens in a build, for reactions"),
    Opener("viseme", 'viseme "SOUND" = "SOUND" 80%', "how the mouth is at a sound"),
    Opener("kind", "kind NAME = eyes 100 apart, at 360 320", "a kind of face of the script's own, with its rows below"),
)
"""What stands outside of all blocks."""

GIVEN: dict[str, str] = {
    "camera": "straight ahead of the face, 60 cm away",
    "people": "the crowd of those who have arrived and not left",
    "away": "12 to 20 degrees aside, down or up, by the seed",
    "left": "the face's own left: the viewer's right",
    "right": "the face's own right: the viewer's left",
    "up": "up",
    "down": "down",
    "neutral": "a sum of nothing: the face at rest",
    "all": "all faces",
    "none": "nothing",
}
"""Words that stand for something everywhere."""

JOINING: dict[str, str] = {
    "until": "a moment: `wait until hello.end`",
    "forever": "until the film's `long`",
    "times": "how often: `repeat 3 times:`",
    "to": "a draw between two values, by the seed; between colours a gradient",
    "with": "the faces of a scene",
    "person": "whom an event brings: `when person arrives as NAME:`",
}
"""Words inside of lines that are no modifiers."""

_CHANNELS = "brow cheek chin ear eye forehead gaze head lid lip mouth muzzle nose pupil"

WORDS: frozenset[str] = frozenset(
    {
        *VERBS,
        *DIRECT,
        *(name.split()[0] for name in (*BLOCKS, *ENDINGS, *DEFINITIONS)),
        *GIVEN,
        *JOINING,
        *_CHANNELS.split(),
    }
)
"""The language's own words: no definition, parameter or label may bear them."""

UNIT_NAME = re.compile(r"AU\d+")
UNDRAWABLE = frozenset({8, 19, 21, *range(29, 41), *range(47, 51), 59, 60})


def undrawable(name: str) -> bool:
    """Whether a name is a FACS unit that no muscle or channel of the model can draw."""
    return bool(UNIT_NAME.fullmatch(name)) and (int(name[2:]) in UNDRAWABLE or int(name[2:]) >= 65)
