"""A table of the project that notes what is asked of it."""

from __future__ import annotations

from collections.abc import ItemsView, Iterator, KeysView, ValuesView
from typing import TYPE_CHECKING, Any, TypeVar

from facescript.resolve.notes import ALL

if TYPE_CHECKING:
    from facescript.resolve.project import Project

T = TypeVar("T")


class Watched(dict[str, T]):
    """A dictionary by names. What is asked of it is noted in the project's notes under its own name."""

    __slots__ = ("name", "project")

    def __init__(self, project: Project, name: str, content: dict[str, T]) -> None:
        super().__init__(content)
        self.project, self.name = project, name

    def _asked(self, key: str = ALL) -> None:
        self.project.notes.asked.add((self.name, key))

    def get(self, key: str, default: Any = None) -> Any:
        self._asked(key)
        return dict.get(self, key, default)

    def __getitem__(self, key: str) -> T:
        self._asked(key)
        return dict.__getitem__(self, key)

    def __contains__(self, key: object) -> bool:
        self._asked(str(key))
        return dict.__contains__(self, key)

    def __iter__(self) -> Iterator[str]:
        self._asked()
        return dict.__iter__(self)

    def __len__(self) -> int:
        self._asked()
        return dict.__len__(self)

    def keys(self) -> KeysView[str]:  # type: ignore[override]
        self._asked()
        return dict.keys(self)

    def values(self) -> ValuesView[T]:  # type: ignore[override]
        self._asked()
        return dict.values(self)

    def items(self) -> ItemsView[str, T]:  # type: ignore[override]
        self._asked()
        return dict.items(self)
