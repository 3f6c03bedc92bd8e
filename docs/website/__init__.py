"""The manual's pages, and those that the language's own tables make, to a site that needs no network."""
