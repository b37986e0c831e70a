"""All classes of motion in a plane of two parameters, however small."""
