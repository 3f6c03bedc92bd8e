"""What can be folded."""

from __future__ import annotations

from analysing import analysis

from facescript.lsp.features.folding import folding

SCRIPT = """\
# one
# two

scene opening:
    together:
        nod

        blink
    # of the scene
    # still

    wait 1s

# alone
show smile 20% +
    AU7 20%
"""


def folds(text: str) -> list[tuple[int, int, str | None]]:
    return [(found.start_line, found.end_line, found.kind) for found in folding(analysis(text))]


def test_blocks_fold_to_their_last_words_and_comments_together() -> None:
    assert folds(SCRIPT) == [
        (0, 1, "comment"),
        (3, 11, None),
        (4, 7, None),
        (8, 9, "comment"),
        (14, 15, None),
    ]


def test_a_block_folds_while_a_line_in_it_cannot_be_read() -> None:
    assert folds('scene a:\n    look at "\n    nod\nscene b\n    nod\n    #ffffff\n') == [(0, 2, None), (3, 5, None)]
