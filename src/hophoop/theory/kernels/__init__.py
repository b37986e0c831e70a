"""The compiled part of theory: from rows of bodies and numbers to columns of answers."""
