"""Initial data of the page: controls, presets, colours, version."""

from __future__ import annotations

from typing import Any

from hophoop._version import __version__
from hophoop.kernel.physics.body import MODE_LETTERS
from hophoop.lab.site.controls import MAP_QUANTITIES, controls
from hophoop.lab.site.presets import FIRST, presets
from hophoop.vocabulary import colors


def setup() -> dict[str, Any]:
    """Return the data that the page is built from, ready for JSON.

    Returns
    -------
    setup : dict
        `version`, `controls`, `map_quantities`, `presets` and `colors`.
    """
    return {
        "version": __version__,
        "controls": controls(),
        "map_quantities": [(name, f"quantity.{name}") for name in MAP_QUANTITIES],
        "presets": [
            {
                "key": p.key,
                "title": f"example.{p.key}",
                "text": f"example.{p.key}.text",
                "query": p.scenario.to_query(),
                "more": k >= FIRST,
            }
            for k, p in enumerate(presets())
        ],
        "colors": {
            # by the letters of a hoop that rolls forward; each mode is shown with the letter of its word
            "modes": dict(zip(MODE_LETTERS, colors.MODES.values(), strict=True)),
            "mode_names": {letter: f"mode.{word}" for letter, word in zip(MODE_LETTERS, colors.MODES, strict=True)},
            "gravity_center": colors.GRAVITY_CENTER,
            "airborne": colors.GRAVITY_CENTER_AIRBORNE,
            "center_speed": colors.CENTER_SPEED,
            "rotation_speed": colors.ROTATION_SPEED,
            "kinetic": colors.KINETIC,
            "potential": colors.POTENTIAL,
            "friction_loss": colors.FRICTION_LOSS,
            "impact_loss": colors.IMPACT_LOSS,
            "normal_force": colors.NORMAL_FORCE,
            "friction_force": colors.FRICTION_FORCE,
            "limit": colors.LIMIT,
        },
    }
