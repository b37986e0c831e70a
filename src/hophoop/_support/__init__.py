"""Files, checksums, extras, processes and signals: what every package may use."""
