"""The module's entries, for tests: the same calls as the page makes, under wasmtime."""

import numpy as np
import wasmtime

from hophoop.kernel.physics.body import Status
from hophoop.kernel.records.cells import CELL, CONTACT
from hophoop.kernel.records.layout import EVENT, SEGMENT
from hophoop.lab.wasm.layout import EVENT_COLUMNS, FATE_COLUMNS, HEADS, SAMPLE_COLUMNS


class Host:
    """One instance of the module, with the records of the motion that it computed last."""

    def __init__(self, path):
        engine = wasmtime.Engine()
        self.store = wasmtime.Store(engine)
        module = wasmtime.Module.from_file(engine, str(path))
        self.exports = wasmtime.Instance(self.store, module, []).exports(self.store)  # it imports nothing
        self.exports["_initialize"](self.store)
        self.events, self.segments = np.empty(0, EVENT), np.empty(0, SEGMENT)

    def call(self, name, *arguments):
        """Call an entry: arrays go into the module's memory, and have what is there afterwards."""
        memory, given, arrays = self.exports["memory"], [], []
        for each in arguments:
            place = each
            if isinstance(each, np.ndarray):
                place = self.exports["malloc"](self.store, each.nbytes)
                memory.write(self.store, each.tobytes(), place)
                arrays.append((each, place))
            given.append(place)
        assert not self.exports[name](self.store, *given)
        for each, place in arrays:
            each[...] = np.ndarray(each.shape, each.dtype, memory.read(self.store, place, place + each.nbytes))
            self.exports["free"](self.store, place)

    def named(self, names, name, *arguments):
        """Numbers that an entry gives in its last argument."""
        out = np.zeros(len(names))
        self.call(name, *arguments, out)
        return dict(zip(names, out.tolist(), strict=True))

    def motion(self, cell):
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

    def samples(self, cell, times):
        """States of the motion that was computed last."""
        out = np.empty((times.size, len(SAMPLE_COLUMNS)))
        self.call("samples", cell, self.segments, len(self.segments), times, times.size, 0, out)
        return out

    def refused(self, cell, contact):
        """The code of the rule that a scenario breaks, and its number."""
        out, given = np.zeros(2), np.array(contact or np.zeros(len(CONTACT)))
        self.call("refused", cell, given, int(not contact), out)
        return tuple(out.tolist())

    def fate(self, cell, most):
        """What becomes of a motion, after at most so many passages of the bottom; by a module of its own."""
        return self.named(FATE_COLUMNS, "fate", cell, most)

    def regions(self, cell, window, columns, rows):
        """Codes of words over the phase plane, and the side of the paradox for each column, for θ̇ < 0 and then for θ̇ > 0."""
        modes, paradox = np.empty((rows, columns), np.uint8), np.empty(2 * columns, np.int8)
        self.call("regions", cell, *window, columns, rows, modes, paradox)
        return modes, paradox
