"""How much work a motion with compliant contact is, told before it starts, and how far work is that takes long."""

from __future__ import annotations

from typing import TYPE_CHECKING, TypeVar

if TYPE_CHECKING:
    from collections.abc import Callable

    import numpy as np
    from rich.console import Console

    from hophoop.scenario import Scenario
    from hophoop.simulation.trajectory import Trajectory

Result = TypeVar("Result")

PART = 0.05  # of the motion is tried
MANY = 100_000  # steps, about a second: fewer are not worth a word
SOON = 1.0  # s after which a motion that is not there yet shows how far it is
LOOKS = 0.1  # s between two looks


def work_ahead(scenario: Scenario) -> str | None:
    """A sentence on the steps that a compliant motion needs, from those of its first part; None where they are few."""
    if scenario.contact.model != "compliant":
        return None
    from hophoop.kernel.compliant.run import MAX_STEPS
    from hophoop.simulation.simulate import simulate

    first = simulate(scenario.replace("duration", max(PART * scenario.duration, 1e-9)))
    steps = len(first.tables["segments"])
    share = first.duration / scenario.duration
    if first.status == "at_rest" or share <= 0.0 or steps / share < MANY:
        return None
    words = f"The first {100 * share:.2g} % of the motion take {steps:,} steps: about {steps / share:,.0f} in all"
    if steps / share <= MAX_STEPS:
        return words + "."
    fewer = "a shorter duration, a lower contact.stiffness or more damping needs fewer"
    return f"{words}, of which {MAX_STEPS:,} are computed; {fewer}."


def with_progress(scenario: Scenario, console: Console) -> Trajectory:
    """The motion; one with compliant contact that takes more than a second shows a bar on a terminal."""
    from hophoop.simulation.simulate import simulate_watched

    if scenario.contact.model != "compliant":
        return simulate_watched(scenario)
    return watched(lambda reached: simulate_watched(scenario, reached), console, "motion")


def watched(compute: Callable[[np.ndarray], Result], console: Console, name: str) -> Result:
    """What `compute` returns; where that takes more than a second, a terminal shows the share that it writes."""
    import threading

    import numpy as np

    reached = np.zeros(1)
    if not console.is_terminal:
        return compute(reached)
    results: list[Result] = []
    errors: list[BaseException] = []

    def work() -> None:
        try:
            results.append(compute(reached))
        except BaseException as error:
            errors.append(error)

    # in a thread beside, which compiled code lets go on: Ctrl-C is heard here, and ends both
    thread = threading.Thread(target=work, daemon=True)
    thread.start()
    thread.join(SOON)
    if thread.is_alive():
        from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

        columns = (TextColumn("{task.description}"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
        with Progress(*columns, console=console, transient=True) as bars:
            task = bars.add_task(name, total=1.0)
            while thread.is_alive():
                bars.update(task, completed=float(reached[0]))
                thread.join(LOOKS)
    if errors:
        raise errors[0]
    return results[0]
