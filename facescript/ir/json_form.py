"""A play to JSON and back, and the schema of that JSON: the same tree for programs that write or read scripts."""

from __future__ import annotations

import dataclasses
import json
from functools import cache
from itertools import accumulate
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from pydantic import ValidationError
from pydantic.json_schema import GenerateJsonSchema
from pydantic_core import CoreSchema, SchemaValidator, core_schema

from facescript.ir import acts, kind, play, values
from facescript.ir.play import Play
from facescript.text import Source, Span

VERSION = 1
"""Of the form; it changes where an older reader would misread."""


class NotAPlay(ValueError):
    """JSON that is no play; `args[0]` says where and why."""


@dataclasses.dataclass(frozen=True)
class Place:
    """A span as JSON has it: a file of the project, lines and columns from 1, the end exclusive."""

    file: str
    line: int
    column: int
    end_line: int
    end_column: int


def dump(play: Play) -> str:
    """A play as indented JSON; the same play gives the same text. Every object says its `type`."""
    return json.dumps({"version": VERSION, "play": _plain(play)}, indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def load(text: str) -> Play:
    """The play of a JSON text. Its spans have the same lines and columns, in sources that hold nothing but blanks.

    Raises `NotAPlay`.
    """
    try:
        form = _validator().validate_json(text)
    except ValidationError as fault:
        first = fault.errors()[0]
        where = ".".join(str(part) for part in first["loc"])
        raise NotAPlay(f"{where}: {first['msg']}") from None
    found = _original(form["play"], _blank_sources(form["play"]))
    assert isinstance(found, Play)
    return found


@cache
def schema() -> dict[str, Any]:
    """The JSON schema of what `dump` writes and `load` reads."""
    return GenerateJsonSchema().generate(_form(), mode="validation")


# ------------------------------------------------------------------------------------------------ to JSON


def _plain(value: Any) -> Any:
    if isinstance(value, Span):
        return dataclasses.asdict(_place(value))
    if isinstance(value, tuple):
        return [_plain(item) for item in value]
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        fields = {field.name: _plain(getattr(value, field.name)) for field in dataclasses.fields(value)}
        return {"type": type(value).__name__, **fields}
    return value


def _place(span: Span) -> Place:
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return Place(span.source.name, line, column, end_line, end_column)


# ------------------------------------------------------------------------------------------------ from JSON


Blanks = dict[str, tuple[Source, list[int]]]
"""By file: a source of blanks, and where its lines start."""


def _original(value: Any, sources: Blanks) -> Any:
    if isinstance(value, list | tuple):
        return tuple(_original(item, sources) for item in value)
    if not isinstance(value, dict):
        return value
    if "file" in value:
        source, starts = sources[value["file"]]
        start = starts[value["line"] - 1] + value["column"] - 1
        return Span(source, start, starts[value["end_line"] - 1] + value["end_column"] - 1)
    fields = {name: _original(item, sources) for name, item in value.items() if name != "type"}
    return _CLASSES[value["type"]](**fields)


def _blank_sources(form: Any) -> Blanks:
    """For each file a source of blank lines long enough for every span in it."""
    widths: dict[str, list[int]] = {}
    _measure(form, widths)
    blanks = {}
    for name, lines in widths.items():
        starts = [0, *accumulate(width + 1 for width in lines)]
        blanks[name] = (Source(name, "\n".join(" " * width for width in lines)), starts)
    return blanks


def _measure(value: Any, widths: dict[str, list[int]]) -> None:
    if isinstance(value, list | tuple):
        for item in value:
            _measure(item, widths)
    elif isinstance(value, dict) and "file" in value:
        lines = widths.setdefault(value["file"], [])
        for line, column in ((value["line"], value["column"]), (value["end_line"], value["end_column"])):
            lines.extend([0] * (line - len(lines)))
            lines[line - 1] = max(lines[line - 1], column - 1)
    elif isinstance(value, dict):
        for item in value.values():
            _measure(item, widths)


# ------------------------------------------------------------------------------------------------ the schema

_CLASSES: dict[str, type] = {
    found.__name__: found
    for module in (values, acts, kind, play)
    for found in vars(module).values()
    if isinstance(found, type) and dataclasses.is_dataclass(found) and found.__module__ == module.__name__
}

_SIMPLE: dict[Any, CoreSchema] = {
    str: core_schema.str_schema(strict=True),
    bool: core_schema.bool_schema(strict=True),
    int: core_schema.int_schema(strict=True),
    float: core_schema.float_schema(allow_inf_nan=False, strict=True),
}

_LINES = core_schema.int_schema(ge=1, le=1_000_000, strict=True)


@cache
def _validator() -> SchemaValidator:
    return SchemaValidator(_form())


@cache
def _form() -> CoreSchema:
    """The whole form: a version and a play, every class of a play a definition of its own."""
    top = core_schema.typed_dict_schema(
        {
            "version": core_schema.typed_dict_field(core_schema.literal_schema([VERSION])),
            "play": core_schema.typed_dict_field(_reference(Play)),
        },
        extra_behavior="forbid",
    )
    definitions = [_definition(found) for found in _CLASSES.values()]
    return core_schema.definitions_schema(top, [*definitions, _place_definition()])


def _reference(found: type) -> CoreSchema:
    return core_schema.definition_reference_schema(found.__name__)


def _definition(found: type) -> CoreSchema:
    """A class as an object with its fields and its `type`; fields with a default may be left out."""
    hints = get_type_hints(found)
    fields = {"type": core_schema.typed_dict_field(core_schema.literal_schema([found.__name__]))}
    for field in dataclasses.fields(found):
        required = field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING
        fields[field.name] = core_schema.typed_dict_field(_hinted(hints[field.name]), required=required)
    return core_schema.typed_dict_schema(fields, extra_behavior="forbid", ref=found.__name__)


def _place_definition() -> CoreSchema:
    fields = {
        field.name: core_schema.typed_dict_field(_SIMPLE[str] if field.name == "file" else _LINES)
        for field in dataclasses.fields(Place)
    }
    return core_schema.typed_dict_schema(fields, extra_behavior="forbid", ref="Place")


def _hinted(hint: Any) -> CoreSchema:
    if hint is Span:
        return _reference(Place)
    if hint in _SIMPLE:
        return _SIMPLE[hint]
    if dataclasses.is_dataclass(hint):
        return _reference(hint)  # type: ignore[arg-type]
    parts = get_args(hint)
    if get_origin(hint) is Literal:
        return core_schema.literal_schema(list(parts))
    if get_origin(hint) is tuple:
        if parts[-1] is Ellipsis:
            return core_schema.list_schema(_hinted(parts[0]))
        return core_schema.tuple_schema([_hinted(part) for part in parts])
    return _union(parts)


def _union(parts: tuple[Any, ...]) -> CoreSchema:
    """A union: objects are told apart by their `type`, and from numbers, texts and null by what they are."""
    objects: list[type] = [part for part in parts if part in _CLASSES.values()]
    others = [part for part in parts if part is not NoneType and part not in objects]
    choices = [_hinted(part) for part in others]
    if len(objects) == 1:
        choices.append(_reference(objects[0]))
    elif objects:
        tagged = {part.__name__: _reference(part) for part in objects}
        choices.append(core_schema.tagged_union_schema(tagged, "type"))
    chosen = choices[0] if len(choices) == 1 else core_schema.union_schema(list(choices))
    return core_schema.nullable_schema(chosen) if NoneType in parts else chosen
