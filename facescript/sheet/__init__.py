"""A face to one picture of all that it can show: cells to poses, poses to a page, and the files."""
