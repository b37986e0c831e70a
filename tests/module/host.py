"""The module's entries, for tests: the same calls as the page makes, under wasmtime."""

from __future__ import annotations

import ctypes
from pathlib import Path
from typing import Any

import numpy as np
import wasmtime

from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.cells import CELL, CONTACT
from hophoop.kernel.records.layout import EVENT, SEGMENT
from hophoop.lab.wasm.layout import EVENT_COLUMNS, FATE_COLUMNS, HEADS, SAMPLE_COLUMNS
from hophoop.maps.grid.kernel import INTEGERS, NUMBERS, WORDS


class Host:
    """One instance of the module, with the records of the motion that it computed last."""

    def __init__(self, path: Path) -> None:
        engine = wasmtime.Engine()
        self.store = wasmtime.Store(engine)
        module = wasmtime.Module.from_file(engine, str(path))
        self.exports: Any = wasmtime.Instance(self.store, module, []).exports(self.store)  # it imports nothing
        self.exports["_initialize"](self.store)
        self.events, self.segments = np.empty(0, EVENT), np.empty(0, SEGMENT)

    def memory(self, place: int, like: np.ndarray) -> np.ndarray:
        """An array of a kind in the module's memory."""
        base = ctypes.addressof(self.exports["memory"].data_ptr(self.store).contents)
        return np.frombuffer((ctypes.c_char * like.nbytes).from_address(base + place), like.dtype).reshape(like.shape)

    def call(self, name: str, *arguments: Any) -> None:
        """Call an entry: arrays go into the module's memory, and have what is there afterwards."""
        arrays = [each for each in arguments if isinstance(each, np.ndarray)]
        places = {id(each): self.exports["malloc"](self.store, each.nbytes) for each in arrays if each.size}
        for each in arrays:
            if each.size:
                self.memory(places[id(each)], each)[...] = each
        given = [places.get(id(each), 0) if isinstance(each, np.ndarray) else each for each in arguments]
        assert not self.exports[name](self.store, *given)
        for each in arrays:
            if each.size:
                each[...] = self.memory(places[id(each)], each)
                self.exports["free"](self.store, places[id(each)])

    def named(self, names: tuple[str, ...], name: str, *arguments: Any) -> dict[str, float]:
        """Numbers that an entry gives in its last argument."""
        out = np.zeros(len(names))
        self.call(name, *arguments, out)
        return dict(zip(names, out.tolist(), strict=True))

    def motion(self, cell: np.ndarray) -> tuple[dict[str, float], np.ndarray]:
        """Heads and events of a motion, with as much memory as it needs."""
        most_events, most_segments, most = 64, 256, int(cell[CELL.index("max_events")])
        while True:
            events, segments = np.empty(most_events, EVENT), np.empty(most_segments, SEGMENT)
            table = np.empty((most_events, len(EVENT_COLUMNS)))
            heads = self.named(HEADS, "motion", cell, events, most_events, segments, most_segments, table)
            if heads["status"] == Status.BUFFER:
                most_segments *= 4
            elif heads["events"] == most_events < most:
                most_events = min(4 * most_events, most)
            else:
                break
        count = int(heads["events"])
        self.events, self.segments = events[:count], segments[: int(heads["segments"])]
        return heads, table[:count]

    def samples(self, cell: np.ndarray, times: np.ndarray, left: bool = False) -> np.ndarray:
        """States of the motion that was computed last."""
        out = np.empty((times.size, len(SAMPLE_COLUMNS)))
        self.call("samples", cell, self.segments, len(self.segments), times, times.size, int(left), out)
        return out

    def refused(self, cell: np.ndarray, contact: tuple[float, ...]) -> tuple[float, ...]:
        """The code of the rule that a scenario breaks, and its number."""
        out, given = np.zeros(2), np.array(contact or np.zeros(len(CONTACT)))
        self.call("refused", cell, given, int(not contact), out)
        return tuple(out.tolist())

    def number(self, name: str, *given: float) -> float:
        """An entry that takes numbers and gives one."""
        return self.named(("value",), name, *given)["value"]

    def hoop_of_parts(self, radius: float, parts: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Mass, ε and κ of parts, and how far each reaches."""
        out, reaches = np.empty(3), np.empty(len(parts))
        self.call("hoop_of_parts", radius, parts, len(parts), out, reaches)
        return out, reaches

    def fate(self, cell: np.ndarray, most: int) -> dict[str, float]:
        """What becomes of a motion, after at most so many passages of the bottom; by a module of its own."""
        return self.named(FATE_COLUMNS, "fate", cell, most)

    def map_cells(self, cells: np.ndarray, span: float, stop: int, timed: bool, wanted: int) -> tuple[np.ndarray, ...]:
        """Reduced quantities of many motions, and the codes of their sequences."""
        n = cells.shape[1]
        kinds = ((len(NUMBERS), np.float64), (len(WORDS), np.int32), (INTEGERS, np.uint64))
        made = tuple(np.empty((n, width), kind) for width, kind in kinds)
        self.call("map_cells", cells, n, span, stop, int(timed), wanted, *made)
        return made

    def regions(self, cell: np.ndarray, window: tuple[float, ...], columns: int, rows: int) -> tuple[np.ndarray, np.ndarray]:
        """Codes of words over the phase plane, and the side of the paradox for each column, for θ̇ < 0 and then for θ̇ > 0."""
        modes, paradox = np.empty((rows, columns), np.uint8), np.empty(2 * columns, np.int8)
        self.call("regions", cell, *window, columns, rows, modes, paradox)
        return modes, paradox
