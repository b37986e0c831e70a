"""Animated plots of a film in 2D: drawn once by Matplotlib, then uncovered over time."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from hophoop._support.extras import need
from hophoop.animate.sheet import FONT, Bytes, Rectangle, Sheet
from hophoop.animate.themes import Theme
from hophoop.plots.curves import LINE, PANELS, curve, values_of
from hophoop.results.poses import Poses
from hophoop.simulation.trajectory import Trajectory
from hophoop.vocabulary import quantities

AHEAD = 0.28  # opacity of the future part of a curve


class Panels:
    """The side panels of a film, of its first motion.

    sheet: gets the axes in `area`: left, bottom, width, height [pixels]; start, end: part of the motion [s].
    """

    def __init__(
        self, sheet: Sheet, area: Rectangle, theme: Theme, motion: Trajectory, names: Sequence[str], start: float, end: float
    ) -> None:
        self.sheet, self.theme = sheet, theme
        self.sample = curve(motion, start, end)
        self.axes: list[tuple[str, Any]] = []
        if not names:
            return
        u, (width, height) = sheet.unit, sheet.size
        left, bottom, wide, high = area
        engine = need("matplotlib.layout_engine", "plots").ConstrainedLayoutEngine
        place = ((left + 8.0 * u) / width, (bottom + 6.0 * u) / height, (wide - 24.0 * u) / width, (high - 6.0 * u) / height)
        sheet.figure.set_layout_engine(engine(rect=place, h_pad=3.0 / 72.0, w_pad=0.0, hspace=0.0))
        over_time = [name for name in names if name != "phase"]
        for name, ax in zip(names, sheet.figure.subplots(len(names), 1, squeeze=False)[:, 0], strict=True):
            self._style(ax, 4 if len(names) < 3 else 2)
            last = not over_time or name == "phase" or name == over_time[-1]
            self._draw_curves(name, ax, motion, wide - 75.0 * u, last)
            self.axes.append((name, ax))
        sheet.render()  # lays out
        sheet.figure.set_layout_engine("none")
        self.full: Bytes = sheet.render()
        for _, ax in self.axes:
            for line in ax.get_lines():
                line.set_alpha(AHEAD)

    def _style(self, ax: Any, most_ticks: int) -> None:
        theme, ticker = self.theme, need("matplotlib.ticker", "plots")
        for axis, most in ((ax.xaxis, 5), (ax.yaxis, most_ticks)):
            axis.set_major_locator(ticker.MaxNLocator(most))
            axis.set_major_formatter(ticker.StrMethodFormatter("{x:g}"))
        ax.set_facecolor(theme.background)
        ax.tick_params(colors=theme.ink, labelsize=FONT)
        ax.spines[:].set_color(theme.muted)
        ax.grid(True, color=theme.muted, alpha=0.22, linewidth=0.8)

    def _draw_curves(self, name: str, ax: Any, motion: Trajectory, room: float, labelled: bool) -> None:
        """Draw the curves of a panel and its title: the quantity, and the keys of several curves in rows of `room` pixels."""
        sample, theme = self.sample, self.theme
        title, curves = PANELS[name]
        shown = [one for one in curves if one.short]
        across = np.degrees(sample.angle) if name == "phase" else sample.t
        for one in shown:
            damper = one.field == "normal_loss" and motion.scenario.contact.model != "rigid"
            values = values_of(one.field, sample, motion.scenario)
            ax.plot(across, values, color=theme.visible(one.color), lw=LINE, label="damper" if damper else one.short)
        if name == "utilization":
            ax.set_ylim(0.0, 1.15)
            ax.set_yticks([0.0, 0.5, 1.0])
        if name != "phase":
            ax.set_xlim(sample.t[0], max(sample.t[-1], np.nextafter(sample.t[0], math.inf)))
        ax.tick_params(labelbottom=labelled)
        if labelled:
            ax.set_xlabel(quantities.ANGLE if name == "phase" else quantities.TIME, color=theme.ink, fontsize=FONT)
        if len(shown) == 1:
            ax.set_title(title, loc="left", fontsize=FONT, color=theme.ink, pad=5.0)
            return
        handles = [need("matplotlib.lines", "plots").Line2D([], [], ls="none"), *ax.get_lines()]
        texts = [title, *(line.get_label() for line in ax.get_lines())]
        widths = np.array([self.sheet.text_width(each) for each in texts]) + 41.0 * self.sheet.unit
        fits = [n for n in range(1, len(texts) + 1) if sum(widths[k::n].max() for k in range(n)) <= room]
        columns = max(fits, default=1)
        order = [k for column in range(columns) for k in range(column, len(texts), columns)]  # legends go down, texts across
        ax.legend(
            [handles[k] for k in order], [texts[k] for k in order], ncols=columns, fontsize=FONT, labelcolor=theme.ink,
            loc="lower left", bbox_to_anchor=(0.0, 1.0), frameon=False, borderpad=0.0, borderaxespad=0.2,
            handlelength=0.9, handletextpad=0.3, columnspacing=0.7, labelspacing=0.2,
        )  # fmt: skip

    def draw(self, t: float, poses: Poses, i: int) -> None:
        """Uncover the curves up to now; poses, i: the present pose."""
        sheet, theme = self.sheet, self.theme
        for name, ax in self.axes:
            box = ax.bbox
            top, low = sheet.size[1] - math.floor(box.y1), sheet.size[1] - math.ceil(box.y0)
            if name == "phase":
                past = int(np.searchsorted(self.sample.t, t))
                here = math.degrees(poses.angle[i]), poses.omega[i]
                way = np.column_stack([np.degrees(self.sample.angle[:past]), self.sample.omega[:past]])
                sheet.line(ax.transData.transform(np.vstack([way, here])), box, color=theme.ink, lw=1.6)
                sheet.dot(ax.transData.transform(here), 11.0, theme.ink, theme.background)
                continue
            x = float(ax.transData.transform((t, 0.0))[0])
            a, b = math.ceil(box.x0), min(math.floor(x), math.floor(box.x1))
            if b > a:
                sheet.pixels[top:low, a:b] = self.full[top:low, a:b]
            sheet.line(np.array([[x, box.y0], [x, box.y1]]), color=theme.muted, lw=1.0)
            for line in ax.get_lines():
                value = float(np.interp(t, *line.get_data()))
                if math.isfinite(value):
                    sheet.dot(ax.transData.transform((t, value)), 8.0, line.get_color(), theme.background)
