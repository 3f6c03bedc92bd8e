"""A video file to its pictures, one after the other, by a program of its own (ffmpeg) that reads this file alone."""

from __future__ import annotations

import subprocess
from collections.abc import Generator
from pathlib import Path
from typing import IO

import imageio_ffmpeg
import numpy as np

from facescript.live.seeing.faces import Picture

FPS = 30
"""Pictures a second that are taken of any video."""

FORMS = "mov,mp4,matroska,webm,avi"
"""What a video may be, in ffmpeg's words: none of them names other files or addresses that are read."""

LARGEST = 4 << 30
"""Bytes of a video."""

LEAST = 40
"""Pixels of a picture's shorter side."""

BLUE_FIRST = "format=rgb24,colorchannelmixer=rr=0:rb=1:br=1:bb=0"
"""Red and blue change places, in ffmpeg's words: that costs this program nothing."""

LONGEST_HEAD = 64


def pictures(path: Path, size: tuple[int, int]) -> Generator[Picture, None, None]:
    """The pictures of a video, `FPS` a second, taken down to a size where they are larger. Raises `ValueError` where
    there is none."""
    if path.stat().st_size > LARGEST:
        raise ValueError(f"it is larger than {LARGEST >> 30} GiB")
    width, height = size
    scaled = f"scale=w='min({width},iw)':h='min({height},ih)':force_original_aspect_ratio=decrease"
    words = [imageio_ffmpeg.get_ffmpeg_exe(), "-hide_banner", "-loglevel", "error", "-nostdin", "-threads", "1"]
    words += ["-protocol_whitelist", "file,pipe", "-format_whitelist", FORMS, "-i", f"file:{path}", "-map", "0:v:0"]
    words += ["-vf", f"fps={FPS},{scaled},{BLUE_FIRST}", "-c:v", "ppm", "-f", "image2pipe", "-"]
    quiet = subprocess.DEVNULL
    process = subprocess.Popen(words, stdin=quiet, stdout=subprocess.PIPE, stderr=quiet)
    try:
        assert process.stdout is not None
        picture = _picture(process.stdout)
        if picture is None:
            raise ValueError("there is no picture in it that can be read (MP4, MOV, MKV, WebM or AVI)")
        if min(picture.shape[:2]) < LEAST:
            raise ValueError(f"its pictures are smaller than {LEAST} pixels")
        while picture is not None:
            yield picture
            picture = _picture(process.stdout)
    finally:
        process.kill()
        process.communicate()


def _picture(stream: IO[bytes]) -> Picture | None:
    """The next picture of a stream of PPM pictures; None where it ends."""
    head = [stream.readline(LONGEST_HEAD) for _ in range(3)]
    if head[0] != b"P6\n" or head[2] != b"255\n":
        return None
    width, height = (int(side) for side in head[1].split())
    data = stream.read(width * height * 3)
    if len(data) < width * height * 3:
        return None
    return np.frombuffer(data, dtype=np.uint8).reshape(height, width, 3)
