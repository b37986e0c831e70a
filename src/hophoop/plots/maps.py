"""Figures of maps: regions of one class each in stable colours, or a number as a field."""

from __future__ import annotations

import json
import math
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from hophoop import theory
from hophoop._support.extras import need
from hophoop.kernel.records import Cell
from hophoop.maps import Border, words_of
from hophoop.maps.grid.axes import has_equal_ratios
from hophoop.maps.grid.cells import make_cells
from hophoop.plots.style import SMALL, Axes, new_axes
from hophoop.scenario import Hoop, InputError, Scenario, describe
from hophoop.vocabulary import colors
from hophoop.vocabulary.colors import class_color
from hophoop.vocabulary.names import SEQUENCE, plain
from hophoop.vocabulary.parameters import FIGURE_LABELS
from hophoop.vocabulary.quantities import with_unit

if TYPE_CHECKING:
    import xarray

SIZE = (8.2, 5.4)
NOT_ALLOWED_COLOR = "#FFFFFF00"  # transparent


def motion_map(
    dataset: xarray.Dataset,
    quantity: str | None = None,
    ax: Axes | None = None,
    borders: Sequence[Border] = (),
    painleve: bool = True,
    most: int = 16,
) -> Axes:
    """Draw a map of two parameters: its classes as coloured regions, or a number as a field.

    The second axis of the map runs to the right, the first one up. Classes have the same colour in every map.
    The dashed line is the minimum friction for Painlevé's paradox. Motions that meet it are hatched if the map
    has the quantity ``painleve``.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map over two axes of numbers, as `hophoop.maps.sweep` returns it.
    quantity : str, optional
        One of its variables; by default the first.
    ax : matplotlib.axes.Axes, optional
        By default a new figure's.
    borders : sequence of Border, optional
        Drawn as lines, as `hophoop.maps.borders` returns them.
    painleve : bool, default True
        Whether Painlevé's region is shown.
    most : int, default 16
        Maximum number of classes in the legend; one line summarizes the rest.

    Returns
    -------
    ax : matplotlib.axes.Axes

    Raises
    ------
    ValueError
        If the map does not have two axes of numbers or has no such variable.
    ImportError
        If Matplotlib is missing.
    """
    quantity = str(next(iter(dataset))) if quantity is None else quantity
    if quantity not in dataset:
        raise InputError.of_field("quantity", quantity, f"one of {', '.join(map(str, dataset))}")
    array = dataset[quantity]
    if array.ndim != 2:
        raise InputError(f"the map must have two axes, not {array.ndim}.")
    up, across = (str(name) for name in array.dims)
    x, y = dataset[across].values, dataset[up].values
    if any(values.dtype.kind != "f" for values in (x, y)):
        raise InputError("the map's axes must be numbers.")
    ax = new_axes(ax, SIZE)
    if "flag_meanings" in array.attrs:
        keys = _classes(ax, quantity, x, y, array.values, words_of(array)[:-1], most)
        place: dict[str, Any] = {"bbox_to_anchor": (1.01, 1.01), "borderaxespad": 0.0, "frameon": False}
    else:
        keys, place = _field(ax, x, y, array), {"framealpha": 0.85, "edgecolor": "none"}
    for border in borders:
        _border(ax, border, across)
    for axis, name, values in ((ax.xaxis, across, x), (ax.yaxis, up, y)):
        axis.set_label_text(_label(dataset, name))
        if has_equal_ratios(values):
            getattr(ax, f"set_{axis.axis_name}scale")("log")
    ax.set_xlim(x[0], x[-1])
    ax.set_ylim(y[0], y[-1])
    if painleve:
        keys += _painleve(ax, dataset, x, y)
    if keys:
        ax.legend(
            handles=keys, loc="upper left", fontsize=SMALL, handlelength=1.3, handleheight=1.1, labelspacing=0.35, **place
        )
    title = _title(dataset, (up, across))
    if title:
        ax.set_title(title, fontsize=9.5, loc="left")
    return ax


def _plan_of(dataset: xarray.Dataset) -> tuple[Scenario, str] | None:
    """Return the scenario and the span of a map, if it has a plan."""
    plan = json.loads(dataset.attrs.get("plan", "null"))
    return plan and (Scenario.from_dict(plan["scenario"]), plan["span"])


def _title(dataset: Any, axes: Sequence[str]) -> str:
    """Return the parameters that are the same in the whole map."""
    plan = _plan_of(dataset)
    if plan is None:
        return ""
    base, span = plan
    return describe(base, without=axes) + ("" if span.startswith("settled") else f", {base.duration:g} s")


def _label(dataset: Any, name: str) -> str:
    text = FIGURE_LABELS.get(name, dataset[name].attrs.get("long_name", name))
    return with_unit(str(text), dataset[name].attrs.get("units", "1"))


def _mesh(ax: Axes, x: Any, y: Any, values: Any, **options: Any) -> Any:
    return ax.pcolormesh(x, y, values, shading="nearest", rasterized=True, **options)


def _classes(ax: Axes, quantity: str, x: Any, y: Any, codes: NDArray[Any], words: list[str], most: int) -> list[Any]:
    """Draw the regions of the classes, and return the keys to their colours."""
    matplotlib_colors = need("matplotlib.colors", "plots")
    paint = [class_color(word, quantity) for word in words]
    scale = matplotlib_colors.ListedColormap([NOT_ALLOWED_COLOR, *paint])
    _mesh(ax, x, y, codes, cmap=scale, vmin=-1.5, vmax=len(words) - 0.5)
    counts = np.bincount(codes[codes >= 0].astype(int).reshape(-1), minlength=len(words))
    shares = counts / codes.size
    order = [int(k) for k in np.argsort(-shares, kind="stable") if counts[k]]
    spaced = words if quantity == SEQUENCE else [plain(word) for word in words]
    entries = [(spaced[k], paint[k], float(shares[k])) for k in order]
    return _keys(entries, most, bool((codes < 0).any()))


def _patch(**look: Any) -> Any:
    return need("matplotlib.patches", "plots").Patch(**look)


def _keys(entries: list[tuple[str, str, float]], most: int, outside: bool) -> list[Any]:
    shown, rest = entries[:most], entries[most:]
    if len(rest) == 1:
        shown, rest = entries, []
    handles = [
        _patch(facecolor=color, edgecolor="black", linewidth=0.4, label=f"{name}  {_percent(share)}")
        for name, color, share in shown
    ]
    if rest:
        together = sum(share for _, _, share in rest)
        handles.append(_patch(facecolor="none", label=f"{len(rest)} more, together {_percent(together)}"))
    if outside:
        handles.append(_patch(facecolor="white", edgecolor="black", linewidth=0.4, label="not allowed"))
    return handles


def _percent(share: float) -> str:
    percent = 100.0 * share
    return f"{percent:.1f} %" if percent >= 0.1 else (f"{percent:.2g} %" if percent >= 0.01 else "< 0.01 %")


def _field(ax: Axes, x: Any, y: Any, array: Any) -> list[Any]:
    """Draw a number as a field with its scale, and return the key to cells without a number."""
    values = array.values.astype(float)
    ax.set_facecolor(colors.LIGHT_GRAY)
    mesh = _mesh(ax, x, y, np.ma.masked_invalid(values), cmap="viridis")
    unit = array.attrs.get("units", "1")
    label = array.attrs.get("long_name", array.name)
    bar = ax.figure.colorbar(mesh, ax=ax, pad=0.02)
    bar.set_label(with_unit(str(label), unit))
    bar.outline.set_visible(False)
    return [_patch(facecolor=colors.LIGHT_GRAY, label="none")] if np.isnan(values).any() else []


def _border(ax: Axes, border: Border, across: str) -> None:
    first, second = (border.x, border.y) if border.window.x == across else (border.y, border.x)
    ax.plot(first, second, color="black", lw=0.7, solid_capstyle="round", zorder=3)


def _painleve(ax: Axes, dataset: Any, x: Any, y: Any) -> list[Any]:
    """Draw the minimum friction for the paradox and hatch the motions that meet it; return the keys to both."""
    keys: list[Any] = []
    excess = _painleve_excess(dataset)
    if excess is not None and (excess > 0).any() and (excess < 0).any():
        ax.contour(x, y, excess, levels=[0.0], colors="black", linewidths=1.1, linestyles="dashed", zorder=4)
        keys += ax.plot([], [], "--", color="black", lw=1.1, label="Painlevé")
    if "painleve" in dataset:
        met = dataset["painleve"].values == 1
        if met.any():
            hatched = ax.contourf(x, y, met.astype(float), levels=[0.5, 1.5], colors="none", hatches=["////"], zorder=4)
            hatched.set_edgecolor((0.0, 0.0, 0.0, 0.55))
            hatched.set_linewidth(0.0)
            keys.append(
                _patch(facecolor="none", edgecolor=(0.0, 0.0, 0.0, 0.55), lw=0.0, hatch="////", label="meets the paradox")
            )
    return keys


def _painleve_excess(dataset: Any) -> NDArray[np.float64] | None:
    """Return the kinetic friction in excess of the paradox's threshold, in every cell."""
    plan = _plan_of(dataset)
    if plan is None:
        return None
    axes = {str(name): dataset[name].values for name in dataset[next(iter(dataset))].dims}
    grid = dict(zip(axes, np.meshgrid(*axes.values(), indexing="ij"), strict=True))
    shape = next(iter(grid.values())).shape
    cells = make_cells(plan[0], {path: values.reshape(-1) for path, values in grid.items()}, math.prod(shape))
    bodies = zip(cells[Cell.ECCENTRICITY].tolist(), cells[Cell.INERTIA_RATIO].tolist(), strict=True)
    threshold = np.array([_least_friction(*body) for body in bodies])
    excess = np.clip(cells[Cell.MU_KINETIC], 0.0, 1e6) - np.clip(threshold, 0.0, 1e6)
    return np.asarray(excess.reshape(shape))


@cache
def _least_friction(eccentricity: float, inertia_ratio: float) -> float:
    """Return the minimum friction for the paradox."""
    if not inertia_ratio > 0.0:
        return math.inf
    return float(theory.painleve_minimum(Hoop(eccentricity=eccentricity, inertia_ratio=inertia_ratio)).mu)
