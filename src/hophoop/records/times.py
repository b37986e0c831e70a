"""Times in seconds as the kernel's own."""

from __future__ import annotations

from hophoop._jit import jit


@jit
def kernel_time(segments, t, second):
    """The time t [s] in kernel units, on the same side of each event as in seconds; at most the end of the motion.

    The time of an event, there and back between the units, can be off by its rounding: on its other side.
    """
    last = segments.shape[0]
    found = min(t / second, segments[last - 1]["t_end"])
    low = 0
    high = last
    while low < high:
        middle = (low + high) // 2
        if segments[middle]["t"] < found:
            low = middle + 1
        else:
            high = middle
    for index in (low - 1, low):
        begin = segments[min(max(index, 0), last - 1)]["t"]
        if begin * second == t:
            found = begin
    return found
