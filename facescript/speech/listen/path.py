"""How likely each state is in each frame to the path of states that is best as a whole (Viterbi; a state lasts)."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]


def best_path(scores: Floats, shortest: Numbers, change: float) -> Numbers:
    """The state of each frame: array[frame].

    `scores` are logarithms, array[frame, state]; a state lasts at least `shortest[state]` frames, and each change costs
    `change`. Where there are fewer frames than any state needs, the likeliest state stands for all.
    """
    count, states = scores.shape
    if count < shortest.min():
        return np.full(count, scores.sum(axis=0).argmax() if count else 0)
    totals = np.concatenate([np.zeros((1, states)), np.cumsum(scores, axis=0, dtype=np.float64)])
    top = np.full(count + 1, -np.inf)
    top[0] = change
    held = np.full(states, -np.inf)
    entered = np.zeros((count + 1, states), dtype=np.bool_)
    winner = np.zeros(count + 1, dtype=np.intp)
    places = np.arange(states)
    for frame in range(1, count + 1):
        begun = np.maximum(frame - shortest, 0)
        entering = np.where(frame >= shortest, top[begun] - change + totals[frame] - totals[begun, places], -np.inf)
        staying = held + scores[frame - 1]
        entered[frame] = entering > staying
        held = np.maximum(entering, staying)
        winner[frame] = held.argmax()
        top[frame] = held[winner[frame]]
    return _traced(winner, entered, shortest)


def _traced(winner: Numbers, entered: NDArray[np.bool_], shortest: Numbers) -> Numbers:
    """The path, from its end back: a state goes back frame by frame to where it was entered."""
    path = np.empty(len(winner) - 1, dtype=np.intp)
    frame = len(path)
    while frame > 0:
        state = winner[frame]
        end = frame
        while not entered[frame, state]:
            frame -= 1
        frame -= int(shortest[state])
        path[frame:end] = state
    return path
