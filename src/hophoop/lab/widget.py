"""The lab's player as a notebook widget, in Jupyter, marimo and any other host of anywidget."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from hophoop._support.extras import need
from hophoop.lab.wasm.stamp import FATES
from hophoop.scenario import InputError, Scenario
from hophoop.simulation.simulate import simulate
from hophoop.simulation.trajectory import Trajectory

if TYPE_CHECKING:
    from anywidget import AnyWidget

PANELS = ("controls", "plots", "map", "theory")


def show(motion: Trajectory | Scenario, panels: Sequence[str] = ("controls", "plots", "theory")) -> AnyWidget:
    """Play a motion in a notebook, with sliders that change it.

    Parameters
    ----------
    motion : Trajectory or Scenario
        The motion to show first.
    panels : sequence of str, default ('controls', 'plots', 'theory')
        Panels next to the player: any of controls, plots, map, theory.

    Returns
    -------
    widget : anywidget.AnyWidget
        Its `motion` is the Trajectory shown, also after a slider has moved; assign another one to show it. Its `query`, the
        scenario's link, changes with it and can be observed. What computes the motion is stored in the notebook: the player
        and its sliders work without a kernel.

    Raises
    ------
    ValueError
        If `motion` is neither, or a panel is unknown.
    ImportError
        If anywidget is missing.
    """
    if isinstance(motion, Scenario):
        motion = simulate(motion)
    if not isinstance(motion, Trajectory):
        raise InputError(f"motion = {type(motion).__name__} must be a Trajectory or a Scenario.", field="motion", value=motion)
    for panel in panels:
        if panel not in PANELS:
            raise InputError(f"panels holds {panel!r}, which must be one of {', '.join(PANELS)}.", field="panels", value=panel)
    widget: AnyWidget = _widget_class()(motion, list(panels))
    return widget


def _widget_class() -> Any:
    """Return the class, made on first use because anywidget belongs to an extra."""
    if _made:
        return _made[0]
    anywidget = need("anywidget", "notebook")
    traitlets = need("traitlets", "notebook")
    from hophoop.lab import export
    from hophoop.lab.limits import within

    class MotionWidget(anywidget.AnyWidget):  # type: ignore[misc, name-defined]
        """A motion with its player and its sliders."""

        _esm = export.static_text("widget.js")
        _css = export.static_text("lab.css")
        # the link of the motion that Python shows, which the page computes
        given = traitlets.Unicode().tag(sync=True)
        panels = traitlets.List().tag(sync=True)
        # the page's scripts and its kernel: sliders need no round trip, even in a notebook exported to HTML
        scripts = traitlets.Dict().tag(sync=True)
        module = traitlets.Bytes().tag(sync=True)
        # of all languages: a saved notebook speaks that of its reader
        words = traitlets.Bytes().tag(sync=True)
        # the scenario's link; changes when another motion is chosen, so that other cells can follow
        query = traitlets.Unicode().tag(sync=True)

        def __init__(self, motion: Trajectory, panels: list[str]) -> None:
            query = motion.scenario.to_query()
            super().__init__(
                given=query,
                panels=panels,
                module=export.packed_module(),
                scripts=export.scripts(),
                words=export.packed_words(),
                query=query,
            )
            self._motion = motion
            self._shown = self.query
            self.on_msg(self._answer)
            self.observe(self._follow, "query")

        @property
        def motion(self) -> Trajectory:
            """The motion that is shown."""
            return self._motion

        @motion.setter
        def motion(self, motion: Trajectory) -> None:
            self._motion = motion
            self._shown = motion.scenario.to_query()
            self.given = self.query = self._shown

        def _follow(self, change: Any) -> None:
            """After an undo, or a switch between two hoops, recompute: the motion shown is not the one computed last."""
            if change["new"] != self._shown:
                self._compute(Scenario.from_query(change["new"]))

        def _compute(self, scenario: Scenario) -> None:
            self._motion = simulate(within(scenario))
            self._shown = scenario.to_query()

        def _answer(self, _: Any, message: Any, buffers: Any) -> None:
            """Send the module of fates, which is larger than most notebooks."""
            self.send({"number": message.get("number")}, [export.packed_module(FATES)])

    _made.append(MotionWidget)
    return MotionWidget


_made: list[Any] = []
