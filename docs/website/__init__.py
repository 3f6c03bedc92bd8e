"""The manual's pages, those of `docs/` and those that the language's own tables make, to a site that needs no network."""
