"""Python code that computes the motion of a scenario."""

from __future__ import annotations

from typing import Any

from hophoop.scenario import Scenario


def python_code(scenario: Scenario) -> str:
    """Return Python code that computes the motion of a scenario.

    Parameters
    ----------
    scenario : Scenario

    Returns
    -------
    code : str
        Code whose variable `motion` is the Trajectory.
    """
    contact = "" if scenario.contact == type(scenario)().contact else f"    contact={_call(scenario.contact)},\n"
    return (
        "import hophoop as hh\n\n"
        "motion = hh.simulate(\n"
        f"    {_call(scenario.hoop)},\n"
        f"    {_call(scenario.plane)},\n"
        f"    {_call(scenario.start)},\n"
        f"    duration={scenario.duration!r},\n"
        f"{contact}"
        ")\n"
        "print(motion.sequence, motion.status)\n"
        "for event in motion.events:\n"
        '    print(f"{event.t:12.6f} s  {event.kind:16}  {event.angle:10.6f} rad")\n'
    )


def _call(model: Any) -> str:
    name = type(model).__name__
    keys = model.to_dict()
    if name == "Start" and "speed" in keys:
        name = "Start.rolling"
    parts = keys.pop("parts", None)
    usual = {"angle": 0.0, "x": 0.0} if name == "Start.rolling" else type(model)().to_dict()
    # arguments that a reader will want to change are written even with their default values
    arguments = [
        f"{key}={_argument(value)}"
        for key, value in keys.items()
        if key in ("load_fraction", "mu") or key not in usual or usual[key] != value
    ]
    if parts is not None:
        listed = ", ".join(_part(part) for part in model.parts)
        arguments.append(f"parts=[{listed}]")
    return f"hh.{name}({', '.join(arguments)})"


def _argument(value: Any) -> str:
    return 'float("inf")' if value == "inf" else repr(value)


def _part(part: Any) -> str:
    keys = {key: value for key, value in part.to_dict().items() if key != "shape"}
    return f"hh.{type(part).__name__}({', '.join(f'{key}={value!r}' for key, value in keys.items())})"
