"""Files of recorded faces to takes: what was recorded of one face, without numpy, so that `check` starts quickly."""
