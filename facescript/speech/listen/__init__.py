"""A recording alone to the phones that a mouth can show: no words, no language."""
