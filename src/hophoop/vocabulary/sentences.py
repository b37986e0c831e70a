"""Sentences about a motion and about the theory of its hoop, filled by Python and by the page, with numbers as texts."""

from __future__ import annotations

from typing import Final

STORY: Final[dict[str, str]] = {
    "start": "It {started} with the load at {where} and the centre at {speed} m/s.",
    "started": "starts and {verb}",
    "started_flight": "starts in the air",
    "started_skim": "starts skimming",
    "slip_start": "It {verb} at {where}; friction reaches its limit: the rim slides ahead.",
    "slip_start_spin": "It {verb} at {where}; friction reaches its limit: the rim turns too fast for its path.",
    "stick": "It rolls again at {where}; the slip has stopped.",
    "slip_reversal": "The slip reverses at {where}; it {verb}.",
    "takeoff": "It hops at {where}.",
    "takeoff_and_landing": "It hops at {where}. It rises {top} and stays up for {time} s.",
    "impact": "It lands at {where} with {speed} m/s downwards and {verb}.",
    "impact_bounce": "It lands at {where} with {speed} m/s downwards and bounces.",
    "impact_without_collision": "An impact without collision at {where} stops the slip; then it {verb}.",
    "turn": "It turns back at {where}.",
    "turn_in_slip": "It turns back at {where}, and {verb} now.",
    "apex": "The centre is highest at {where}: the gap is {gap}.",
    "bounce_limit": "Infinitely many bounces end here, at {where}.",
    "painleve_inconsistent": "Painlevé's paradox at {where}: no contact force agrees with this slip.",
    "painleve_indeterminate": "Painlevé's paradox at {where}: several contact forces agree with it.",
    "jam": "Dynamic jam at {where}: the contact force grows without bound.",
    "kane_gain": "Newton's law of impact has created {gain} J (Kane's example).",
    "skim": "No contact force is left at {where}: the load falls freely and the rim skims the plane.",
    "rest": "It rests at {where}.",
    "rest_unstable": "It rests at {where}, which is not stable.",
    "end": "",
    "other": "{kind} at {where}.",
    "more_bounces": "It bounces {count} more times.",
    "left_out": "… and {count} more.",
}
"""Sentences for events, by kind and variant."""

SUMMARY: Final[dict[str, str]] = {
    "change": "{phrase} at {where}",
    "bounces": "bounces",
    "without_collision": "stops its slip at once",
    "more_bounces": "and {count} more times",
    "more_changes": ", … ({count} more)",
    "sentence": "{phrases}. {ending}",
}
"""Parts of the one-sentence summary of a motion."""

THEORY: Final[dict[str, str]] = {
    "first_slip": "Slips",
    "first_hop": "Hops",
    "immediate_hop": "Hops at once",
    "needed_friction": "Friction for pure rolling",
    "painleve": "Painlevé’s paradox",
    "jam": "Dynamic jam",
    "rest": "Rests stably",
    "loss": "End of rolling",
    "loss_by_friction": "at {where} friction reaches its limit",
    "loss_of_contact": "at {where} the contact force is gone",
    "would_slip": "would slip",
    "would_hop": "would hop in its first turn",
    "would_hop_at_once": "would hop at once",
    "any_push": "{would}: any push is enough",
    "any_speed": "{would}: at any speed",
    "no_speed": "never, at any speed",
    "above": "{would} above {speed} m/s",
    "no_friction": "no friction keeps it rolling",
    "friction_enough": "μ = {mu} would keep it rolling (enough here)",
    "friction_short": "μ = {mu} would keep it rolling (more than there is)",
    "never": "never",
    "paradox_here": "from μ = {mu} on, at {where}: possible here",
    "paradox_not_here": "from μ = {mu} on, at {where}: not here",
    "jam_at": "can end a slip at {places}",
    "rest_at": "with the load at {where}",
    "uphill": "Slips, hops",
    "no_threshold": "no single threshold uphill (β < 0): it depends on where the hoop turns back; see the map",
}
"""Thresholds of theory: their names and texts."""

LEAST_SPEED: Final = 1e-9
"""Critical speeds below this are not shown as speeds [m/s]."""

LAB: Final[dict[str, str]] = {
    "too_long": "duration = {duration:g} must be at most {most:g} s in the lab; the library itself has no such limit.",
    "too_many_parts": "hoop.parts has {parts} parts and must have at most {most} in the lab.",
    "too_many_turns": (
        "duration = {duration:g} s at this speed and radius is about {turns:.0e} revolutions and must be at most {most:.0e} "
        "in the lab; the library itself has no such limit."
    ),
    "too_stiff": (
        "contact.stiffness, contact.slip_speed and duration need about {steps:.0e} steps of integration and must need at "
        "most {most:.0e} in the lab."
    ),
    "too_many_changes": "changes has {pairs} pairs and must have at most {most} in the lab.",
    "too_many_cells": "x.cells times y.cells = {cells} must be at most {most} in the lab.",
    "equal_axes": "x.path and y.path are both {path!r} and must differ.",
    "two_axes": "{one} and {other} cannot both be axes: they say the same thing in two ways.",
    "rigid_maps": "contact.model = 'compliant' must be 'rigid' for a map.",
    "cell_turns": "A cell of this map is about {turns:.0e} revolutions and must be at most {most:.0e} in the lab.",
    "map_turns": (
        "x and y make {cells} cells of about {turns:.2g} revolutions in all, and must be at most {most:.0e} in the lab; take "
        "fewer cells, lower speeds or a shorter duration."
    ),
    "doubt": (
        "After {time} s the motion depends on more digits than this page computes. Run it in hophoop lab or Python for the "
        "exact result."
    ),
    "compliant_changes": "With a compliant contact no derivatives are computed: choose the rigid contact model.",
    "not_a_pair": "changes holds {change}, which is not a pair of path and value.",
    # one value, after the field and how it was given
    "window": "must be four numbers, θ from and to [rad], θ̇ from and to [rad/s], each pair rising",
    "times": "must be two times, from and to [s], rising from 0",
    "number_path": "must be a number's path, not that of a word",
    "one_of": "must be one of {known}",
}
"""Refusals of the lab, filled as by `str.format`."""
