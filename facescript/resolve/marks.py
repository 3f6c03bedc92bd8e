"""Marks on the clock: `hello.end`, `hello."cup".2`; whether the word is in the line is looked at when all is known."""

from __future__ import annotations

from facescript.ir.acts import Say
from facescript.ir.values import Mark
from facescript.ir.wording import marked, occurrences
from facescript.resolve.project import Project
from facescript.resolve.reader import spelled
from facescript.resolve.scope import Scope
from facescript.syntax.tree import Dotted, Name
from facescript.text import Span

EDGES = ("start", "end")


def mark_of(project: Project, word: Name | Dotted, scope: Scope) -> Mark | None:
    """The mark that a name is, or None where its first part is no label. Raises `Refused`."""
    first = word.text if isinstance(word, Name) else str(word.parts[0])
    label = scope.label(first)
    if label is None:
        return None
    parts = list(zip(word.parts, word.quoted, strict=True))[1:] if isinstance(word, Dotted) else []
    spoken, nth, edge = None, 1, "start"
    if parts and parts[0][1]:
        spoken = str(parts.pop(0)[0])
        if parts and isinstance(parts[0][0], int):
            nth = int(parts.pop(0)[0])
    if parts and parts[0][0] in EDGES and not parts[0][1]:
        edge = str(parts.pop(0)[0])
    if parts or nth < 1:
        raise project.refuse("FS233", word.span, text=spelled(word), label=first)
    mark = Mark(label, edge, spoken, nth)
    if spoken is not None:
        project.marks.append((mark, word.span))
    return mark


def check_marks(project: Project) -> None:
    """Reports each mark on a word that its line does not have; labels whose statement failed are let pass."""
    for mark, span in project.marks:
        if mark.word is None or mark.label not in project.lines:
            continue
        line = project.lines[mark.label]
        if line is None:
            project.report("FS230", span, label=mark.label, word=mark.word)
        else:
            check_word(project, line, mark.word, mark.nth, span)


def check_word(project: Project, line: Say, word: str, nth: int, span: Span) -> bool:
    """Whether a line has the `nth` `word`, or mark of that name; if not, that is reported. A text that could not be
    read has its fault told elsewhere."""
    if not line.text:
        if line.recording is not None or line.times is not None:
            project.report("FS520", span, word=word)
        return line.recording is None and line.times is None
    count = len(marked(line, word) or occurrences(line.text, word))
    if count == 0 and line.times is not None and _in_file(project, line, word, nth):
        return True
    if count == 0:
        project.report("FS228", span, word=word, text=shortened(line.text))
    elif nth < 1 or nth > count:
        times = "once" if count == 1 else f"{count} times"
        project.report("FS229", span, word=word, nth=nth, times=times)
    return 1 <= nth <= count


def _in_file(project: Project, line: Say, word: str, nth: int) -> bool:
    from facescript.speech.timing.line import has_mark  # a dozen modules: only lines with files of times pay it

    return has_mark(line, project.world_of(line.times or ""), word, nth)


def shortened(text: str) -> str:
    return text if len(text) <= 60 else text[:57] + "..."
