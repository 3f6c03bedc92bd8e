"""A score and its curves to one picture: lanes of acts over panels of channels."""
