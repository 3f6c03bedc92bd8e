"""`viseme "SOUND" = ...`: what an author says of how the mouth is at a sound."""

from __future__ import annotations

from facescript.diagnostics.model import Related
from facescript.ir.play import Viseme
from facescript.resolve.mixes import drivers_of
from facescript.resolve.project import Project
from facescript.resolve.reader import Reader
from facescript.resolve.scope import GLOBAL
from facescript.resolve.sums import left_over, read_quantity
from facescript.resolve.units import SHARE
from facescript.speech.mouth.ipa import letters
from facescript.speech.mouth.visemes import PLAIN
from facescript.syntax.tree import Phrase, String, VisemeDefinition

LONGEST = 16
"""Characters of a sound."""

FORM = 'it is written `viseme "θ" = "s" 80%`, or with the mouth\'s channels: `viseme "θ" = mouth.tongue 100%`'


def viseme(project: Project, node: VisemeDefinition) -> None:
    """Gives the project the viseme of a sound. Raises `Refused`."""
    sound = node.sound.value
    if not letters(sound) or len(sound) > LONGEST:
        reason = f"a sound is an IPA sign or two, at most {LONGEST}, such as `θ` or `tʃ`"
        raise project.refuse("FS523", node.sound.span, sound=sound, reason=reason)
    earlier = project.visemes_at.get(sound)
    if earlier is not None:
        raise project.refuse("FS524", node.sound.span, related=(Related(earlier, "here"),), sound=sound)
    project.visemes_at[sound] = node.sound.span
    words = node.value.words
    if words and isinstance(words[0], String):
        project.visemes[sound] = _like(project, sound, words[0], node.value)
        return
    drivers = drivers_of(project, node.value)
    if any(not driver.name.startswith("mouth.") for driver in drivers):
        reason = f"a shape moves the mouth alone; {FORM}"
        raise project.refuse("FS523", node.value.span, sound=sound, reason=reason)
    project.visemes[sound] = Viseme(sound, drivers=drivers)


def _like(project: Project, sound: str, other: String, value: Phrase) -> Viseme:
    if not letters(other.value) or PLAIN.unknown(other.value):
        reason = f"the table has no shape for `{other.value}` either; {FORM}"
        raise project.refuse("FS523", other.span, sound=sound, reason=reason)
    degree = 1.0
    if len(value.words) > 1:
        reader = Reader(value.words[1:], GLOBAL, value.span)
        degree = float(read_quantity(project, reader, SHARE, draws=False))  # type: ignore[arg-type]
        left_over(project, reader)
    return Viseme(sound, other.value, degree)
