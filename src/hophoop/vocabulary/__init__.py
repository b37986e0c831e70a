"""Tables of facts, one row per parameter, mode, kind of event, quantity, law and status, for all other packages."""
