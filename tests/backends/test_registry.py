"""The table of outputs: what a plug-in names is loaded, or the author is told why not."""

from __future__ import annotations

import pytest

from facescript.backends.job import JobFailure
from facescript.backends.registry import Backend


@pytest.mark.parametrize("target", ["no_such_package:write", "facescript.backends.wav:no_such_function"])
def test_an_output_that_cannot_be_loaded_says_so(target: str) -> None:
    with pytest.raises(JobFailure, match=f"`{target}` cannot be loaded"):
        Backend(".x", target, "from a plug-in").load()
