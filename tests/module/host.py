"""The module's entries, for tests: the same calls as the page makes, under wasmtime."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Any

import numpy as np
import wasmtime

from hophoop.kernel.compliant.records import WIDTH
from hophoop.kernel.compliant.run import MAX_STEPS
from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.cells import CELL, CONTACT
from hophoop.kernel.records.layout import EVENT, SEGMENT
from hophoop.lab.wasm.layout import CHANGE_COLUMNS, CHOSEN, EVENT_COLUMNS, FATE_COLUMNS, HEADS, SAMPLE_COLUMNS, THRESHOLDS
from hophoop.maps.grid.kernel import INTEGERS, NUMBERS, WORDS


class Calls:
    """The entries with memory of their own; what runs them says how."""

    def __init__(self, events: int = 1024, segments: int = 4096) -> None:
        self.most_events, self.most_segments = events, segments
        self.cell = self.room(8 * len(CELL))
        self._take()
        self.heads = self.room(8 * len(HEADS))
        self.contact = self.room(8 * len(CONTACT))

    def room(self, size: int) -> int:
        """Memory of so many bytes."""
        raise NotImplementedError

    def free(self, place: int) -> None:
        """Give memory back."""
        raise NotImplementedError

    def view(self, place: int, count: int, kind: Any = np.float64) -> np.ndarray:
        """Numbers in that memory."""
        raise NotImplementedError

    def call(self, name: str, *arguments: Any) -> None:
        """Call an entry."""
        raise NotImplementedError

    def motion(self, cell: np.ndarray) -> tuple[dict[str, float], np.ndarray]:
        """Heads and events of a motion, with as much room as it needs."""
        self.view(self.cell, len(CELL))[:] = cell
        most = int(cell[CELL.index("max_events")])
        while True:
            self.call(
                "motion", self.cell, self.events, self.most_events, self.segments, self.most_segments, self.table, self.heads
            )  # fmt: skip
            heads = dict(zip(HEADS, self.view(self.heads, len(HEADS)).tolist(), strict=True))
            if heads["status"] == Status.BUFFER:
                self._give(4 * self.most_segments, self.most_events)
            elif heads["events"] == self.most_events < most:
                self._give(self.most_segments, min(4 * self.most_events, most))
            else:
                break
        width = len(EVENT_COLUMNS)
        return heads, self.view(self.table, int(heads["events"]) * width).reshape(-1, width).copy()

    def _give(self, segments: int, events: int) -> None:
        for place in (self.segments, self.events, self.table):
            self.free(place)
        self.most_segments, self.most_events = segments, events
        self._take()

    def _take(self) -> None:
        self.events = self.room(EVENT.itemsize * self.most_events)
        self.segments = self.room(SEGMENT.itemsize * self.most_segments)
        self.table = self.room(8 * self.most_events * len(EVENT_COLUMNS))

    def compliance(self, cell: np.ndarray, contact: np.ndarray) -> dict[str, float]:
        """What a compliant contact makes of its numbers."""
        self.view(self.cell, len(CELL))[:] = cell
        self.view(self.contact, len(CONTACT))[:] = contact
        self.call("compliance", self.cell, self.contact, self.heads)
        return dict(zip(CHOSEN, self.view(self.heads, len(CHOSEN)).tolist(), strict=True))

    def compliant_motion(
        self, cell: np.ndarray, contact: np.ndarray, times: np.ndarray, most_rows: int = 20_000
    ) -> tuple[dict[str, float], np.ndarray, np.ndarray, np.ndarray]:
        """Heads, events, and the states at some times just after and just before."""
        self.view(self.cell, len(CELL))[:] = cell
        self.view(self.contact, len(CONTACT))[:] = contact
        rows = self.room(8 * WIDTH * most_rows)
        self.call(
            "compliant_motion", self.cell, self.contact, self.events, self.most_events, MAX_STEPS, rows, most_rows,
            self.table, self.heads,
        )  # fmt: skip
        heads = dict(zip(HEADS, self.view(self.heads, len(HEADS)).tolist(), strict=True))
        assert heads["status"] != Status.BUFFER
        width, columns = len(EVENT_COLUMNS), len(SAMPLE_COLUMNS)
        events = self.view(self.table, int(heads["events"]) * width).reshape(-1, width).copy()
        when, out = self.room(8 * times.size), self.room(8 * times.size * columns)
        self.view(when, times.size)[:] = times
        states = []
        for left in (0, 1):
            self.call(
                "compliant_samples", self.cell, self.contact, rows, int(heads["segments"]), when, times.size, left, out
            )  # fmt: skip
            states.append(self.view(out, times.size * columns).reshape(-1, columns).copy())
        for place in (rows, when, out):
            self.free(place)
        return heads, events, states[0], states[1]

    def refused(self, cell: np.ndarray, contact: tuple[float, ...]) -> tuple[float, ...]:
        """The code of the rule that a scenario breaks, and its number."""
        self.view(self.cell, len(CELL))[:] = cell
        self.view(self.contact, len(CONTACT))[:] = contact or 0.0
        self.call("refused", self.cell, self.contact, int(not contact), self.heads)
        return tuple(self.view(self.heads, 2).tolist())

    def number(self, name: str, *given: float) -> float:
        """An entry that takes numbers and gives one."""
        self.call(name, *given, self.heads)
        return float(self.view(self.heads, 1)[0])

    def hoop_of_parts(self, radius: float, parts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Mass, ε and κ of parts, and how far each reaches."""
        table, out, reaches = self.room(8 * parts.size), self.room(24), self.room(8 * len(parts))
        self.view(table, parts.size)[:] = parts.ravel()
        self.call("hoop_of_parts", radius, table, len(parts), out, reaches)
        found = self.view(out, 3).copy(), self.view(reaches, len(parts)).copy()
        for place in (table, out, reaches):
            self.free(place)
        return found

    def samples(self, segments: int, times: np.ndarray, left: bool = False) -> np.ndarray:
        """States of the motion that was computed last."""
        width = len(SAMPLE_COLUMNS)
        when, out = self.room(8 * times.size), self.room(8 * times.size * width)
        self.view(when, times.size)[:] = times
        self.call("samples", self.cell, self.segments, segments, when, times.size, int(left), out)
        result = self.view(out, times.size * width).reshape(-1, width).copy()
        self.free(when)
        self.free(out)
        return result

    def changes(self, cell: np.ndarray, rates: np.ndarray, sign: float) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """Rates of all events of a motion, the reasons why there are none and the events from which on; by its own module."""
        heads, events = self.motion(cell)
        n, width = rates.shape[1], len(CHANGE_COLUMNS)
        size = len(events) * width * n
        more, out, why = self.room(8 * rates.size), self.room(8 * size), self.room(16 * n)
        self.view(more, rates.size)[:] = rates.ravel()
        self.call(
            "changes", self.cell, more, n, sign, self.events, len(events), self.segments,
            int(heads["segments"]), heads["doubt"], out, why,
        )  # fmt: skip
        found = self.view(out, size).reshape(len(events), width, n).copy()
        reasons, failed = self.view(why, 2 * n).reshape(2, n).copy()
        for place in (more, out, why):
            self.free(place)
        return found, reasons, failed

    def fate(self, cell: np.ndarray, most: int) -> dict[str, float]:
        """What becomes of a motion, after at most so many passages of the bottom; by the module of derivatives."""
        self.view(self.cell, len(CELL))[:] = cell
        out = self.room(8 * len(FATE_COLUMNS))
        self.call("fate", self.cell, most, out)
        found = dict(zip(FATE_COLUMNS, self.view(out, len(FATE_COLUMNS)).tolist(), strict=True))
        self.free(out)
        return found

    def thresholds(self, cell: np.ndarray, speed: float) -> dict[str, float]:
        """What theory says."""
        self.view(self.cell, len(CELL))[:] = cell
        self.call("thresholds", self.cell, speed, self.heads)
        return dict(zip(THRESHOLDS, self.view(self.heads, len(THRESHOLDS)).tolist(), strict=True))

    def map_cells(self, cells: np.ndarray, span: float, stop: int, timed: bool, wanted: int) -> tuple[np.ndarray, ...]:
        """Reduced quantities of many motions, and the codes of their sequences."""
        n = cells.shape[1]
        place = self.room(8 * cells.size)
        kinds = ((len(NUMBERS), np.float64), (len(WORDS), np.int32), (INTEGERS, np.uint64))
        rooms = [self.room(n * width * np.dtype(kind).itemsize) for width, kind in kinds]
        self.view(place, cells.size)[:] = cells.ravel()
        self.call("map_cells", place, n, span, stop, int(timed), wanted, *rooms)
        made = tuple(
            self.view(room, n * width, kind).reshape(n, width).copy() for room, (width, kind) in zip(rooms, kinds, strict=True)
        )
        for room in (place, *rooms):
            self.free(room)
        return made

    def regions(
        self, cell: np.ndarray, window: tuple[float, float, float, float], columns: int, rows: int
    ) -> tuple[np.ndarray, np.ndarray]:
        """Codes of words over the phase plane, and the side of the paradox for each column, for θ̇ < 0 and then for θ̇ > 0."""
        self.view(self.cell, len(CELL))[:] = cell
        modes, sides = self.room(columns * rows), self.room(2 * columns)
        self.call("regions", self.cell, *window, columns, rows, modes, sides)
        found = self.view(modes, columns * rows, np.uint8).reshape(rows, columns).copy()
        paradox = self.view(sides, 2 * columns, np.int8).copy()
        self.free(modes)
        self.free(sides)
        return found, paradox


class Host(Calls):
    """One instance of the module, under wasmtime."""

    def __init__(self, path: Path) -> None:
        engine = wasmtime.Engine()
        self.store = wasmtime.Store(engine)
        module = wasmtime.Module.from_file(engine, str(path))
        self.imports = [f"{item.module}.{item.name}" for item in module.imports]
        exports: Any = wasmtime.Instance(self.store, module, []).exports(self.store)
        self.exports = exports
        self.call("_initialize")
        super().__init__()

    def room(self, size: int) -> int:
        place: int = self.exports["malloc"](self.store, size)
        assert place
        return place

    def free(self, place: int) -> None:
        self.exports["free"](self.store, place)

    def view(self, place: int, count: int, kind: Any = np.float64) -> np.ndarray:
        memory = self.exports["memory"]
        base = ctypes.addressof(memory.data_ptr(self.store).contents)
        size = np.dtype(kind).itemsize * count
        return np.frombuffer((ctypes.c_char * size).from_address(base + place), kind)

    def call(self, name: str, *arguments: Any) -> None:
        assert not self.exports[name](self.store, *arguments)
