"""Times in seconds as the kernel's own."""

from __future__ import annotations

from hophoop._jit import jit


@jit
def kernel_time_of(begins, end, t, second):
    """The time t [s] in kernel units, on the same side of each event as in seconds; at most the end of the motion.

    `begins` are the times at which its segments begin. The time of an event, there and back between the units, can be off
    by its rounding: on its other side.
    """
    count = begins.shape[0]
    found = min(t / second, end)
    low = 0
    high = count
    while low < high:
        middle = (low + high) // 2
        if begins[middle] < found:
            low = middle + 1
        else:
            high = middle
    for index in (low - 1, low):
        begin = begins[min(max(index, 0), count - 1)]
        if begin * second == t:
            found = begin
    return found


@jit
def kernel_time(segments, t, second):
    """`kernel_time_of` a motion's segments."""
    return kernel_time_of(segments["t"], segments[segments.shape[0] - 1]["t_end"], t, second)
