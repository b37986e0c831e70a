"""How events carry derivatives over: the conditions that set them off, impacts, what follows."""
