"""Conversion of times in seconds to kernel units."""

from __future__ import annotations


def kernel_times(begins, end, times, second, out):
    """Fill `out` with times [s] in kernel units, on the same side of each event as in seconds; at most the end of the motion.

    `begins` are the start times of the segments. Converted to seconds and back, the time of an event may differ by rounding and
    move to the event's other side. So a time equal to an event's time in seconds is mapped exactly to the event, and likewise
    for the end.
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
