"""Who is seen: sightings to persons that faces look at, follow, and let go of."""
