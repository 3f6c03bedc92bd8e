"""Messages of an editor to what the server may rely on: every request is answered, columns are UTF-16 units."""

from __future__ import annotations

import logging
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException
from pygls.protocol import LanguageServerProtocol


class FaceProtocol(LanguageServerProtocol):
    """What pygls reads, but for what an editor could be hurt by."""

    def structure_message(self, data: dict[str, Any]) -> Any:
        """A message as an object. A request that is not well formed is refused at once: pygls leaves it without an
        answer, for which an editor would wait. Raises `JsonRpcException`."""
        try:
            message = super().structure_message(data)
        except JsonRpcException as fault:
            if "method" in data and isinstance(data.get("id"), (int, str)):
                self._send_response(data["id"], error=fault.to_response_error())
            raise
        if isinstance(message, types.InitializeRequest) and message.params.capabilities.general is not None:
            # pygls would take the unit that the editor likes best (UTF-8 in some); all editors know UTF-16
            message.params.capabilities.general.position_encodings = None
        return message


def quiet_refusals(record: logging.LogRecord) -> bool:
    """Whether a record is worth an editor's log: what is refused with a sentence is no fault of the server."""
    return not (record.exc_info and isinstance(record.exc_info[1], JsonRpcException))
