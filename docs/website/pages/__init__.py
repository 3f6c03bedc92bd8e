"""The pages that tables make: one module a kind of page, each with `pages()`."""
