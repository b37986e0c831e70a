"""The compiled part of gaits: passages of a section, and the fate of a motion."""
