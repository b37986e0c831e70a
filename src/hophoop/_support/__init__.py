"""Files, checksums, extras, processes and signals, for use by every package."""
