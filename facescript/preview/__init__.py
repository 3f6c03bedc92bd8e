"""A script to a page that plays it beside its text, and follows both as they change."""
