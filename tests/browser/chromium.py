"""A headless Chromium for the tests: opens a page, runs script in it, takes its picture."""

from __future__ import annotations

import base64
import io
import json
import shutil
import subprocess
import tempfile
import time
from pathlib import Path
from types import TracebackType
from typing import Any

import imageio.v3 as iio
import numpy as np
from numpy.typing import NDArray
from websockets.sync.client import connect

NAMES = ("chromium", "chromium-browser", "google-chrome")
FLAGS = (
    "--headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking "
    "--disable-component-update --disable-sync --hide-scrollbars --mute-audio --allow-file-access-from-files "
    "--force-color-profile=srgb --autoplay-policy=no-user-gesture-required --remote-debugging-port=0"
).split()


def program() -> str | None:
    """Where Chromium is, or None."""
    return next((found for name in NAMES if (found := shutil.which(name))), None)


class Page:
    """One page of a browser of its own, `width` x `height` CSS pixels, one device pixel each."""

    def __init__(
        self, address: str, width: int = 1280, height: int = 720, sound: bool = True, calm: bool = False
    ) -> None:
        """`sound`: pages may start it by themselves; `calm`: the viewer prefers reduced motion."""
        self.folder = tempfile.mkdtemp()
        flags = [flag for flag in FLAGS if sound or "autoplay" not in flag]
        flags += ["--force-prefers-reduced-motion"] if calm else []
        binary = program()
        assert binary is not None
        words = [binary, *flags, f"--user-data-dir={self.folder}", f"--window-size={width},{height}", "about:blank"]
        self.process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.number = 0
        self.socket = connect(self._target(), max_size=None, compression=None, legacy=True)
        self.call("Page.enable")
        metrics = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.call("Emulation.setDeviceMetricsOverride", **metrics)
        self.call("Page.navigate", url=address)
        self._until_loaded()

    def __enter__(self) -> Page:
        return self

    def __exit__(self, kind: type[BaseException] | None, value: BaseException | None, at: TracebackType | None) -> None:
        self.socket.close()
        self.process.terminate()
        self.process.wait(timeout=20)
        shutil.rmtree(self.folder, ignore_errors=True)

    def run(self, script: str) -> Any:
        """The value of an expression in the page; promises are awaited."""
        answer = self.call("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True)
        assert "exceptionDetails" not in answer, answer["exceptionDetails"]
        return answer["result"].get("value")

    def picture(self) -> NDArray[np.uint8]:
        """What the page shows: array[row, column, rgb]."""
        data = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        return np.asarray(iio.imread(io.BytesIO(data)))[..., :3]

    def click(self, x: int, y: int) -> None:
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def call(self, method: str, **parameters: Any) -> Any:
        """One command of the DevTools protocol and its result."""
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            answer = json.loads(self.socket.recv(timeout=120))
            if answer.get("id") == self.number:
                assert "error" not in answer, answer
                return answer["result"]

    def _until_loaded(self) -> None:
        for _ in range(600):
            if self.run("document.readyState === 'complete' && location.href !== 'about:blank'"):
                return
            time.sleep(0.05)
        raise AssertionError("the page did not load")

    def _target(self) -> str:
        """The address of the first page's debugger."""
        import urllib.request

        place = Path(self.folder) / "DevToolsActivePort"
        for _ in range(600):
            if place.exists() and place.read_text().strip():
                break
            time.sleep(0.05)
        port = place.read_text().split()[0]
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/json/list", timeout=20) as answer:
            pages = [entry for entry in json.load(answer) if entry["type"] == "page"]
        return str(pages[0]["webSocketDebuggerUrl"])
