"""The play: what a script means, before times are solved."""
