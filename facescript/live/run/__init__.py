"""A play that is performed as its events come: happenings and sightings in, frames, marks and utterances out."""
