"""The page: its files, its controls and the motions to start from."""
