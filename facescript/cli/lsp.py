"""`facescript lsp`: the language server, on standard input and output, or on a port of this machine."""

from __future__ import annotations

import argparse
from importlib.util import find_spec

from facescript.cli.report import OptionFault

LOOPBACK = "127.0.0.1"


def run(options: argparse.Namespace) -> int:
    """Serves until the editor ends it. Raises `OptionFault`."""
    if find_spec("pygls") is None:
        raise OptionFault("FS960", command="lsp", extra="lsp")
    from facescript.lsp.server import make_server

    server = make_server()
    if options.tcp is not None:
        server.start_tcp(LOOPBACK, options.tcp)
    elif options.ws is not None:
        server.start_ws(LOOPBACK, options.ws)
    else:
        server.start_io()
    return 0
