"""The lab: an interactive page, its programming interface over HTTP, the same player as a notebook widget."""
