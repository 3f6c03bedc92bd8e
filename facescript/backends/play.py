"""The resolved play, its schema and its solved times to `.json`."""

from __future__ import annotations

import json
from pathlib import Path

from facescript.backends.job import Job
from facescript.ir.json_form import dump, schema
from facescript.schedule.explain import as_objects, explain


def write_json(job: Job, path: Path) -> None:
    """The play as `dump` has it (`version`, `play`), with `times` (what `explain --json` prints) and its `schema`."""
    whole = json.loads(dump(job.play)) | {"times": as_objects(explain(job.score)), "schema": schema()}
    path.write_text(json.dumps(whole, ensure_ascii=False, indent=1) + "\n", "utf-8", newline="\n")
