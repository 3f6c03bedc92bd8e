"""What a script may name to what an editor says of it: a head of one line, and a few words of Markdown below."""

from __future__ import annotations

from facescript.lsp.vocabulary import kind_of_face, parameters_of, recipe
from facescript.performance.channels import CHANNELS
from facescript.resolve.drivers import PRIMITIVES
from facescript.resolve.kinds.library import kinds_with
from facescript.resolve.meanings import FACES, MUSCLES_DO, comment_of
from facescript.resolve.names import Definition
from facescript.resolve.project import Project
from facescript.resolve.units import EXAMPLES
from facescript.resolve.words import BLOCKS, DEFINITIONS, ENDINGS, GIVEN, JOINING, Modifier, Verb
from facescript.syntax import tree

LONGEST = 400
"""Characters of a definition that are shown."""


def code(text: str) -> str:
    return f"```face\n{text}\n```"


def verb_text(verb: Verb) -> str:
    """How a verb is written, what it does, and which modifiers it takes."""
    parts = [code(verb.form), f"{verb.help[:1].upper()}{verb.help[1:]}."]
    if verb.default:
        parts.append(f"Unless said: {verb.default}.")
    if verb.modifiers:
        parts.append("Takes " + ", ".join(f"`{name}`" for name in verb.modifiers) + ".")
    return "\n\n".join(parts)


def modifier_text(row: Modifier) -> str:
    return f"{code(row.form)}\n\n{row.help}"


def word_text(name: str) -> str | None:
    """What a word of the language does that is no verb; None for any other name."""
    row = BLOCKS.get(name) or DEFINITIONS.get(name) or ENDINGS.get(name)
    if row is not None:
        return f"{code(row.form)}\n\n{row.help}"
    says = GIVEN.get(name) or JOINING.get(name)
    return f"`{name}`: {says}" if says else None


def primitive_text(name: str) -> str:
    """What a muscle or a channel is, by the name an author writes."""
    muscle = name.removesuffix(".left").removesuffix(".right")
    primitive = PRIMITIVES[name]
    only = kinds_with(primitive.names[0])
    says = [MUSCLES_DO[muscle]] if muscle in MUSCLES_DO else []
    says.append(f"a channel in {_units(primitive.names[0])}, written `{name} {EXAMPLES[primitive.kind]}`")
    if only:
        says.append("only faces with it show it: " + ", ".join(only))
    return f"**{name}**: " + "; ".join(says)


def _units(name: str) -> str:
    unit = next((channel.unit for channel in CHANNELS if channel.name == name), "1")
    return "percent" if unit == "1" else unit


def head_of(definition: Definition) -> str:
    """`action greet(who, warmth = 60%)`: what a definition is, in one line."""
    given = ", ".join(" ".join(parameter.span.text.split()) for parameter in parameters_of(definition))
    return f"{definition.kind} {definition.name}" + (f"({given})" if given else "")


def definition_text(project: Project, definition: Definition) -> str:
    """What a definition is: as it is written, what its comment says, and of an expression what it drives."""
    parts = [code(_written(definition))]
    if comment := comment_of(definition.node.span):
        parts.append(comment)
    if definition.kind == "face" and (kind := kind_of_face(definition)) in FACES:
        parts.append(f"{FACES[kind]}.")
    if definition.kind == "expression" and (driven := recipe(project, definition)) is not None:
        parts.append(f"Moves {driven}.")
    parts.append(f"*{_home(definition)}*")
    return "\n\n".join(parts)


def _written(definition: Definition) -> str:
    """The definition, of an action its head."""
    if isinstance(definition.node, tree.ActionDefinition):
        return f"{head_of(definition)}:"
    text = definition.node.span.text.rstrip()
    return text if len(text) <= LONGEST else text[:LONGEST].rstrip() + " ..."


def _home(definition: Definition) -> str:
    if definition.library:
        return "of the library"
    return f"{definition.span.source.name}:{definition.span.source.position(definition.span.start)[0]}"
