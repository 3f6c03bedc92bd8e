"""The Lab Streaming Layer keeps to this machine in tests; it reads that when it is first imported."""

from __future__ import annotations

import os
from pathlib import Path

os.environ["LSLAPICFG"] = str(Path(__file__).with_name("lsl_api.cfg"))
