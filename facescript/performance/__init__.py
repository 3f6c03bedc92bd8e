"""Channels, easing and sampling."""
