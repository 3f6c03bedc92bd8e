"""The values of a frame to the pose of one face: what an avatar is driven with."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from facescript.live.address import Address, AddressFault
from facescript.live.model import Layout
from facescript.performance.channels import INDEX, POSE


class Posed:
    """One face of a layout."""

    def __init__(self, layout: Layout, face: str) -> None:
        self.face = face
        prefix = f"{face}." if len(layout.faces) > 1 else ""
        own = [(index, name.removeprefix(prefix)) for index, name in enumerate(layout.names) if name.startswith(prefix)]
        known = [(index, INDEX[name]) for index, name in own if name in INDEX]
        self._of = np.array([index for index, _ in known], dtype=np.intp)
        self._to = np.array([index for _, index in known], dtype=np.intp)
        self._rest = np.array([channel.rest for channel in POSE])

    def pose(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """array[channel of a frame] to array[channel of POSE]; what the face has not is at rest."""
        pose = self._rest.copy()
        pose[self._to] = values[self._of]
        return pose


def chosen(layout: Layout, address: Address) -> Posed:
    """The face that an address names, else the first. Raises `AddressFault` where there is none."""
    name = address.options.get("face") or next(iter(layout.faces), None)
    if name is None:
        raise AddressFault("FS982", address=address.text, reason="the script has no face that is seen")
    if name not in layout.faces:
        known = ", ".join(f"`{face}`" for face in layout.faces)
        raise AddressFault("FS982", address=address.text, reason=f"the script has no face `{name}`; there is {known}")
    return Posed(layout, name)
