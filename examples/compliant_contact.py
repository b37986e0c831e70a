"""Figures of the page on compliant contact: its convergence to the rigid plane, and its landings.

Usage: python examples/compliant_contact.py [FOLDER]   (default: docs/figures)
"""

from __future__ import annotations

import argparse
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from hophoop.article import compliant_figures as figures
from hophoop.article import convergence as study


def main(folder: Path) -> None:
    """Draw all figures and print their numbers."""
    folder.mkdir(parents=True, exist_ok=True)
    k = study.STIFFNESSES

    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.6), layout="constrained", sharey=True)
    for ax, title, contact in (
        (axes[0], "slip speed 1/k (default)", {}),
        (axes[1], "slip speed fixed at 10⁻⁴ √(g R)", {"slip_speed": 1e-4}),
    ):
        errors = study.convergence(k, **contact)
        figures.error_lines(errors, k, ax)
        ax.set_title(title, fontsize="medium")
        for name, values in errors.items():
            print(title, name, " ".join(f"{value:.1e}" for value in values))
    axes[1].set_ylabel("")
    keep(figure, folder / "compliant-convergence.svg")

    figure, axes = plt.subplots(1, 2, figsize=(10.0, 4.2), layout="constrained")
    matched = study.matched_landings()
    lines = {f"e = {e}, c = {number:.3f} √(k m)": errors for e, (number, errors) in matched.items()}
    figures.error_lines(lines, k, axes[0])
    axes[0].set_title("landing at v₀ = 3.1 m/s, damping matched to e", fontsize="medium")
    paradox = {
        "inconsistent": study.painleve_errors(0.0, "flight"),
        "indeterminate, impact": study.painleve_errors(5.0, "impact"),
        "inconsistent, Hunt–Crossley": study.painleve_errors(0.0, "flight", law="hunt-crossley"),
    }
    figures.error_lines(paradox, k, axes[1])
    axes[1].set_title("slip in Painlevé's region", fontsize="medium")
    for name, values in {**lines, **paradox}.items():
        print(name, " ".join(f"{value:.1e}" for value in values))
    keep(figure, folder / "compliant-landing-order.svg")

    figure, axes = plt.subplots(1, 3, figsize=(10.0, 4.2), layout="constrained")
    figures.landing_against_stiffness(10.0 ** np.arange(1.0, 10.5, 0.5), axes[0])
    figures.landing_against_slip_speed(10.0 ** np.arange(-8.0, 0.25, 0.25), ax=axes[1])
    figures.landing_against_restitution(np.linspace(0.0, 1.0, 11), ax=axes[2])
    keep(figure, folder / "compliant-landing.svg")

    draw_energy(folder)


def draw_energy(folder: Path) -> None:
    """Energies of both models, narrow enough for their text to be read."""
    figure, axes = plt.subplots(1, 2, figsize=(8.5, 4.4), layout="constrained", sharey=True)
    figures.energy_balance(*axes)
    for ax in axes:
        title = ax.get_title(loc="left")
        ax.set_title(title, loc="left", pad=38, fontsize=12)  # above the names of events
        for words in ax.get_legend().get_texts():
            words.set_fontsize(9)
    keep(figure, folder / "compliant-energy.svg")


def keep(figure: plt.Figure, path: Path) -> None:
    """Save a figure without a date, so that the same numbers give the same file."""
    figure.savefig(path, metadata={"Date": None})
    plt.close(figure)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", nargs="?", type=Path, default=Path(__file__).parent.parent / "docs" / "figures")
    main(parser.parse_args().folder)
