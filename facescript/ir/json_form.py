"""A play to JSON and back, and the schema of that JSON: the same tree for programs that write or read scripts."""

from __future__ import annotations

import dataclasses
import json
from functools import cache
from types import NoneType
from typing import Any, Literal, get_args, get_origin, get_type_hints

from pydantic import ValidationError
from pydantic.json_schema import GenerateJsonSchema
from pydantic_core import CoreSchema, SchemaValidator, core_schema

from facescript.ir import acts, kind, play, values
from facescript.ir.json_places import MARK, Find, Places, Unfit, lacking, mark, place_of, places_itself
from facescript.ir.play import Play
from facescript.text import Source, Span

VERSION = 1
"""Of the form; it changes where an older reader would misread."""


ADDED = ("times", "schema")
"""What a build adds to a play for its readers."""


class NotAPlay(ValueError):
    """JSON that is no play; `args[0]` says where and why, `span` is the place in the JSON as far as it can be told."""

    def __init__(self, reason: str, span: Span) -> None:
        super().__init__(reason)
        self.span = span


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


def nowhere(name: str) -> Source | None:
    """No file is known."""
    return None


def load(text: str, name: str = "play.json", find: Find = nowhere) -> Play:
    """The play of a JSON text; what a build adds to it (`times`, `schema`) is passed over.

    Its spans have the lines and columns of the JSON, in the sources that `find` has by their names, else in sources
    that hold nothing but blanks. What has no place of its own is where it stands in the JSON, the file `name`.
    Raises `NotAPlay`.
    """
    whole = Source(name, text)
    try:
        form = _validator().validate_json(text)
    except ValidationError as fault:
        first = fault.errors(include_url=False)[0]
        where = ".".join(str(part) for part in first["loc"])
        raise NotAPlay(f"{where}: {first['msg']}", place_of(whole, first["loc"])) from None
    try:
        if lacking(form["play"], _CLASSES):
            mark(form["play"], whole)
        found = _original(form["play"], Places(form["play"], whole, find))
    except Unfit as fault:
        raise NotAPlay(fault.args[0], Span(whole, 0, 0)) from None
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


def _original(value: Any, places: Places) -> Any:
    if isinstance(value, list | tuple):
        return tuple(_original(item, places) for item in value)
    if not isinstance(value, dict):
        return value
    if "file" in value:
        return places.span(value)
    found = _CLASSES[value["type"]]
    fields = {name: _original(item, places) for name, item in value.items() if name not in ("type", MARK)}
    if MARK in value and "span" not in value and places_itself(found):
        fields["span"] = places.here(value)
    return found(**fields)


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
            **dict.fromkeys(ADDED, core_schema.typed_dict_field(core_schema.any_schema(), required=False)),
        },
        extra_behavior="forbid",
    )
    definitions = [_definition(found) for found in _CLASSES.values()]
    return core_schema.definitions_schema(top, [*definitions, _place_definition()])


def _reference(found: type) -> CoreSchema:
    return core_schema.definition_reference_schema(found.__name__)


def _definition(found: type) -> CoreSchema:
    """A class as an object with its fields and its `type`; places, and fields with a default, may be left out."""
    hints = get_type_hints(found)
    fields = {"type": core_schema.typed_dict_field(core_schema.literal_schema([found.__name__]))}
    for field in dataclasses.fields(found):
        missing = field.default is dataclasses.MISSING and field.default_factory is dataclasses.MISSING
        required = missing and hints[field.name] is not Span
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
