"""The animated SVG: a performance to one file that plays by itself."""
