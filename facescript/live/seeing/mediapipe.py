"""A picture to the faces that MediaPipe finds in it (BlazeFace, Bazarevsky and others 2019), where it is installed."""

from __future__ import annotations

from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from facescript.live.seeing.faces import Picture, distinct
from facescript.live.seeing.geometry import FACE, Box

SURE = 0.5
"""What it must be to its own mind, 0 to 1."""

FAR = 1
"""Its model for faces to 5 m; 0 is that for 2 m."""


def installed() -> bool:
    """Whether a MediaPipe is there that comes with its models: up to 0.10.21 it does."""
    found = find_spec("mediapipe")
    folders = found.submodule_search_locations if found is not None else None
    return any((Path(folder) / "python" / "solutions").is_dir() for folder in folders or ())


class MediaPipe:
    """It looks at whole pictures alone: that takes it a few milliseconds. Raises `OSError` where it does not start."""

    width = FACE

    def __init__(self) -> None:
        try:
            import mediapipe
        except ImportError as fault:
            raise OSError(
                f"MediaPipe is installed and does not start ({fault}); `by=cascade` goes without it"
            ) from None
        solution = mediapipe.solutions.face_detection
        self._detection: Any = solution.FaceDetection(model_selection=FAR, min_detection_confidence=SURE)

    def faces(self, picture: Picture, near: Sequence[Box] | None = None) -> list[Box]:
        """The frames of the faces, pixels."""
        if near is not None and not near:
            return []
        found = self._detection.process(np.ascontiguousarray(picture[:, :, ::-1])).detections or ()
        return distinct(self._box(detection, picture) for detection in found)

    def _box(self, detection: Any, picture: Picture) -> Box:
        high, wide = picture.shape[:2]
        frame = detection.location_data.relative_bounding_box
        return Box(frame.xmin * wide, frame.ymin * high, frame.width * wide, frame.height * high)
