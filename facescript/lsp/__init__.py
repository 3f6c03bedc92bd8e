"""The language server: what an editor asks about scripts, answered by the compiler."""
