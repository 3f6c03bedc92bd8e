"""Documents that are open in an editor to what the compiler says of them; text that is not saved yet counts.

A document belongs to the project that is the innermost folder of the editor's workspace around it, else to the folder
that it lies in; scripts that it uses are read as they stand in the editor, where they are open there.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path

from pygls.uris import from_fs_path, to_fs_path
from pygls.workspace import TextDocument, Workspace

from facescript.compile import Compiled
from facescript.recompile import Recompiler
from facescript.speech.voices.known import KnownTimes
from facescript.text import Source
from facescript.world import LARGEST_SCRIPT, World, WorldFailure, decode

KEPT = 32
"""Analyses that are kept."""


@dataclass(frozen=True, slots=True)
class OpenWorld(World):
    """A project of which some files are open: `texts` by their real paths."""

    texts: dict[Path, str] = field(default_factory=dict, hash=False, compare=False)

    def read(self, name: str, largest: int = LARGEST_SCRIPT) -> bytes:
        text = self.texts.get(self.path(name)) if self.texts else None
        return World.read(self, name, largest) if text is None else text.encode("utf-8", "surrogatepass")

    def exists(self, name: str) -> bool:
        return World.exists(self, name) or name in self.opened()

    def stamp(self, name: str) -> object:
        try:
            text = self.texts.get(self.path(name)) if self.texts else None
        except WorldFailure:
            text = None
        return World.stamp(self, name) if text is None else text

    def opened(self) -> list[str]:
        """The names of the open files that belong to the project."""
        root = self.root.resolve()
        return [path.relative_to(root).as_posix() for path in self.texts if path.is_relative_to(root)]


@dataclass(frozen=True, slots=True)
class Analysis:
    """What is known of a document as it stood in the editor."""

    uri: str
    version: int | None
    world: OpenWorld
    compiled: Compiled

    @property
    def source(self) -> Source:
        return self.compiled.source

    def uri_of(self, source: Source) -> str | None:
        """The address of a file of the project; None for what is none, such as the library."""
        if source is self.source:
            return self.uri
        try:
            path = self.world.path(source.name)
        except WorldFailure:
            return None
        return from_fs_path(str(path)) if path.is_file() or path in self.world.texts else None


class Desk:
    """The analyses of the documents that an editor's `workspace` holds, each made once for a state of all of them."""

    def __init__(self, workspace: Workspace) -> None:
        self._workspace = workspace
        self._made: dict[str, tuple[object, Analysis]] = {}
        self._compilers: dict[str, Recompiler] = {}
        self._voices: dict[str, KnownTimes] = {}

    def analysis(self, uri: str) -> Analysis:
        """The document as it stands now."""
        state = self._state()
        made = self._made.get(uri)
        if made is not None and made[0] == state:
            return made[1]
        found = self._analysed(uri)
        self._made.pop(uri, None)
        self._made[uri] = state, found
        while len(self._made) > KEPT:
            oldest = next(iter(self._made))
            del self._made[oldest]
            for made_for in (self._compilers, self._voices):
                made_for.pop(oldest, None)
        return found

    def worlds(self) -> list[OpenWorld]:
        """The projects at hand: the folders of the workspace, and those of open documents that lie in none of them."""
        texts = self._texts()
        roots = dict.fromkeys((*self._folders(), *(self.root(path) for path in texts)))
        return [OpenWorld(root, texts) for root in roots]

    def latest(self, uri: str) -> Analysis:
        """The document as it stood when it was last looked at: what serves while an author types."""
        made = self._made.get(uri)
        return made[1] if made is not None else self.analysis(uri)

    def source(self, uri: str) -> Source:
        """The text of a document as it stands now."""
        document = self._workspace.get_text_document(uri)
        return Source(document.uri, _plain(document.source))

    def _state(self) -> object:
        """What all open documents hold; not their versions, which an editor may give twice."""
        return tuple((uri, document.source) for uri, document in self._workspace.text_documents.items())

    def _analysed(self, uri: str) -> Analysis:
        document = _readable(self._workspace.get_text_document(uri))
        path = Path(to_fs_path(uri) or "untitled.face")
        world = OpenWorld(self.root(path), self._texts())
        source = Source(_name(world, path), _plain(document.source))
        compiler = self._compilers.setdefault(uri, Recompiler())
        return Analysis(uri, document.version, world, compiler.compile(source, world, self._voice(uri, world)))

    def _voice(self, uri: str, world: World) -> KnownTimes:
        """The voice of a document: the same as long as it says the same, for what is kept of its times rests on it."""
        before = self._voices.get(uri)
        voice = self._voices[uri] = KnownTimes(world) if before is None else before.turn_to(world)
        return voice

    def root(self, path: Path) -> Path:
        """The folder of the project that a file belongs to."""
        roots = [folder for folder in self._folders() if path.is_relative_to(folder)]
        return max(roots, key=lambda folder: len(folder.parts), default=path.parent)

    def _folders(self) -> Iterable[Path]:
        addresses = [*self._workspace.folders, *([self._workspace.root_uri] if self._workspace.root_uri else [])]
        return [Path(path) for address in addresses if (path := to_fs_path(address))]

    def _texts(self) -> dict[Path, str]:
        found = {}
        for uri, document in self._workspace.text_documents.items():
            path = to_fs_path(uri)
            if path and uri.startswith("file:"):
                found[Path(path).resolve()] = _plain(document.source)
        return found


def _name(world: World, path: Path) -> str:
    try:
        return path.resolve().relative_to(world.root.resolve()).as_posix()
    except ValueError:
        return path.name


def _readable(document: TextDocument) -> TextDocument:
    """A document that is not open and whose file cannot be read is empty."""
    try:
        document.source  # noqa: B018 (it reads the file)
    except (OSError, ValueError):
        return TextDocument(document.uri, "", document.version)
    return document


def _plain(text: str) -> str:
    """A text with plain line ends, as the compiler reads files."""
    return decode(text.encode("utf-8", "replace").replace(b"\0", b" "))
