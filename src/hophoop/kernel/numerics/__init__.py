"""What solves the formulas and knows no hoop."""
