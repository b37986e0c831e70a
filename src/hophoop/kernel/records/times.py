"""Times in seconds as the kernel's own."""

from __future__ import annotations


def kernel_times(begins, end, times, second, out):
    """Fill `out` with times [s] in kernel units, on the same side of each event as in seconds; at most the end of the motion.

    `begins` are the times at which its segments begin. The time of an event, there and back between the units, can be off
    by its rounding: on its other side. So the time of an event in seconds is the event's own, and the last one is the end.
    """
    last = begins.shape[0] - 1
    for k in range(times.shape[0]):
        found = min(times[k] / second, end)
        low = 0
        high = last + 1
        while low < high:
            middle = (low + high) // 2
            if begins[middle] < found:
                low = middle + 1
            else:
                high = middle
        for index in (low - 1, low):
            begin = begins[min(max(index, 0), last)]
            if begin * second == times[k]:
                found = begin
        if end * second == times[k]:
            found = end
        out[k] = found
