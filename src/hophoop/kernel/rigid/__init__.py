"""The rigid contact model: the event loop in nopython mode and the dense sampling of its result."""
