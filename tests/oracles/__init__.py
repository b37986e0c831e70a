"""Independent solutions of the rolling hoop, against which ``hophoop`` is measured.

Nothing in these modules imports ``hophoop``. The equations of motion are rederived from the Lagrangian in
coordinates (x, y, θ) of the rim's centre, with the contact force as a multiplier in one augmented linear
system, and never reduced to the contact-space formulas that the program uses. They repeat the program's formulas on
purpose: kernel, extended precision and derivatives share theirs, so that only these can show a mistake in one.

* :mod:`oracles.cases`     the scenarios of the reference data
* :mod:`oracles.mechanics` mass matrix, forces, energies: plain numbers and arrays
* :mod:`oracles.events`    impact, mode rule and events where a motion meets the plane
* :mod:`oracles.hybrid`    SciPy's DOP853 with event location: double precision, any scenario
* :mod:`oracles.precise`   Taylor series in mpmath: as many digits as wanted
* :mod:`oracles.elliptic`  rolling time by elliptic integrals
* :mod:`oracles.rational`  impacts in exact fractions, or in the numbers of the two above

:mod:`oracles.derivatives` is none of them: it changes a parameter a little and solves with many digits of hophoop.
"""
