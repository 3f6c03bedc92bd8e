"""A client that sends whatever it is told to, well formed or not, and reads what comes back."""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any, BinaryIO

COMMAND = [sys.executable, "-m", "facescript.cli.main", "lsp"]


class RoughClient:
    """A session with a server of its own. `log` takes what the server writes to standard error."""

    def __init__(self, log: BinaryIO | int, command: Sequence[str] = COMMAND) -> None:
        self._server = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log)
        assert self._server.stdin is not None and self._server.stdout is not None
        self._out, self._in = self._server.stdin, self._server.stdout
        self._number = 0

    def begin(self, folder: Path, **capabilities: object) -> Any:
        """The answer to `initialize`."""
        params = {"processId": None, "rootUri": folder.as_uri(), "capabilities": capabilities}
        found = self.ask("initialize", params)
        self.tell("initialized", {})
        return found

    def end(self) -> int:
        """The server's return code once it was asked to stop."""
        self.ask("shutdown", None)
        self.tell("exit", None)
        return self._server.wait(20)

    def kill(self) -> None:
        self._server.kill()
        self._server.wait()

    def raw(self, data: bytes) -> None:
        self._out.write(data)
        self._out.flush()

    def send(self, message: object) -> None:
        body = json.dumps(message).encode()
        self.raw(b"Content-Length: %d\r\n\r\n" % len(body) + body)

    def tell(self, method: str, params: object) -> None:
        self.send({"jsonrpc": "2.0", "method": method, "params": params})

    def ask(self, method: str, params: object) -> Any:
        """What is answered: the whole message."""
        self._number += 1
        self.send({"jsonrpc": "2.0", "id": self._number, "method": method, "params": params})
        while True:
            message = self._read()
            if message.get("id") == self._number and "method" not in message:
                return message

    def _read(self) -> Any:
        size = 0
        while (line := self._in.readline()) != b"\r\n":
            assert line, "the server is gone"
            if line.lower().startswith(b"content-length:"):
                size = int(line.partition(b":")[2])
        return json.loads(self._in.read(size))
