"""The lab: an interactive page, its programming interface over HTTP and the same player as a notebook widget."""
