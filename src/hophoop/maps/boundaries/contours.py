"""All boundaries of a map: contours of its classes, with every crossing of a grid line bisected to rounding."""

from __future__ import annotations

import itertools
import json
from typing import TYPE_CHECKING

import numpy as np

from hophoop._support.extras import need
from hophoop.maps.boundaries.classes import SLIVER, Border, Classifier, Floats, Integers, first_changes, make_window
from hophoop.maps.grid.axes import has_equal_ratios
from hophoop.scenario import InputError, Scenario

if TYPE_CHECKING:
    import xarray


def borders(dataset: xarray.Dataset, quantity: str = "sequence") -> list[Border]:
    """Return the boundaries between the classes of a map of two axes.

    They have a point wherever a boundary crosses a line of the grid between two classes, to rounding. Classes that lie between
    grid points are not seen, and a boundary ends within a cell of its junction. `boundary` follows one of them more finely.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map over two parameters.
    quantity : str, default 'sequence'
        Quantities that define the classes.

    Returns
    -------
    borders : list of Border
        The longest first; a border that crosses one grid line has one point.

    Raises
    ------
    ValueError
        If the map does not have two increasing axes of numbers, or the quantity has no classes.
    ImportError
        If a library of the extra ``maps`` is missing.
    """
    if "plan" not in getattr(dataset, "attrs", {}):
        raise InputError("dataset must be a map of hophoop.maps.sweep.", field="dataset", value=dataset)
    plan = json.loads(dataset.attrs["plan"])
    if len(plan["axes"]) != 2:
        raise InputError(f"the map must have two axes, not {len(plan['axes'])}.")
    axes = {path: np.asarray(dataset[path].values) for path in plan["axes"]}
    if any(v.dtype.kind != "f" or v.size < 2 or not (np.diff(v) > 0).all() for v in axes.values()):
        raise InputError("the map's axes must be growing numbers.")
    base = Scenario.from_dict(plan["scenario"])
    ranges = {path: (values[0], values[-1]) for path, values in axes.items()}
    window = make_window(base, ranges, [path for path, values in axes.items() if has_equal_ratios(values)])
    classify = Classifier(base, window, [quantity], plan["span"])
    grid = np.stack(np.meshgrid(*axes.values(), indexing="ij"), axis=-1)
    return curves(classify, grid, classify.at(grid))


def curves(classify: Classifier, grid: Floats, codes: Integers) -> list[Border]:
    """Return the borders between the classes of grid points."""
    contour_generator = need("contourpy", "maps").contour_generator
    # contourpy's x is the first index of the grid, and the class is on the left of its lines
    lines = [
        (code, line)
        for code in np.unique(codes).tolist()
        for line in contour_generator(z=(code == codes.T).astype(float)).lines(0.5)
    ]
    if not lines:
        return []
    # vertices are the middles of edges, in grid lines
    edges = np.concatenate([line for _, line in lines])
    lengths = [len(line) for _, line in lines]
    inner = np.repeat([code for code, _ in lines], lengths)
    one, other = np.floor(edges).astype(int), np.ceil(edges).astype(int)
    inside = np.where((codes[tuple(one.T)] == inner)[:, None], one, other)
    near, far = tuple(inside.T), tuple((one + other - inside).T)
    sliver = SLIVER * np.ptp([classify.window.x_range, classify.window.y_range], axis=1)

    def middle(near: Floats, far: Floats) -> Floats:
        by_ratio = np.sqrt(np.abs(near)) * np.sqrt(np.abs(far))
        found = np.where(classify.window.logarithmic, by_ratio, 0.5 * (near + far))
        return np.clip(found, np.minimum(near, far), np.maximum(near, far))[np.newaxis]

    points, outer = first_changes(classify.at, grid[near], grid[far], inner, sliver, middle)
    seen = outer == codes[far]  # not a third class between grid points
    parts = np.split(np.arange(len(edges)), np.cumsum(lengths)[:-1])
    runs = [run for rows in parts for run in _runs(rows, edges, outer)]
    found: list[Border] = []
    taken: set[object] = set()
    # a border is seen from both of its sides, and whole from that of the wider class
    for rows, ends in sorted(runs, key=lambda run: -run[0].size):
        right, left = int(outer[rows[0]]), int(inner[rows[0]])
        crossings = {(u, v, frozenset((right, left))) for u, v in edges[rows].tolist()}
        if (rows.size > 1 or seen[rows[0]]) and not crossings <= taken:
            taken |= crossings
            x, y = points[rows].T
            found.append(Border(classify.window, x, y, (classify.names[right], classify.names[left]), ends))
    return found


def _runs(rows: Integers, edges: Floats, outer: Integers) -> list[tuple[Integers, tuple[str, str]]]:
    """Return the parts of a contour with one class beyond, and their ends."""
    cuts = np.flatnonzero(np.diff(outer[rows])) + 1
    end = "edge"
    if (edges[rows[0]] == edges[rows[-1]]).all():
        if cuts.size == 0:
            return [(rows, ("closed", "closed"))]
        # start at a junction; the last point is the first one again
        rows, end = np.roll(rows[1:], 1 - cuts[0]), "junction"
        cuts = cuts[1:] - cuts[0]
    ends = [end, *("junction" for _ in cuts), end]
    return list(zip(np.split(rows, cuts), itertools.pairwise(ends), strict=True))
