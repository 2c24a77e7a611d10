"""Histories of driven ends, body forces and heat sources: value, integral, and mean over a step."""

import math

import numba as nb

from hugoniot.core.target import BY_ADDRESS, GUARD


@nb.njit(**GUARD)
def pulse_value(time, pulse, table):
    """Value of a boundary's pulse; `pulse` = (shape code, amplitude, start, duration), `table` = (times; values)."""
    shape, amplitude, since, duration = int(pulse[0]), pulse[1], time - pulse[2], pulse[3]
    if shape == 1:
        times, values = table[0], table[1]
        if time <= times[0]:
            return values[0]
        for k in range(1, times.shape[0]):
            if time < times[k]:
                return values[k - 1] + (values[k] - values[k - 1]) * (time - times[k - 1]) / (times[k] - times[k - 1])
        return values[-1]
    if since < 0.0:
        return 0.0
    if shape == 0:
        return amplitude
    if shape == 2:
        return amplitude * math.exp(-since / duration)
    if shape == 3:
        return amplitude * math.sin(math.pi * since / duration) if since < duration else 0.0
    if shape == 4:
        return amplitude if since < duration else 0.0
    return amplitude * min(since / duration, 1.0)


@nb.njit(**BY_ADDRESS)
def pulse_integral(time, pulse, table):
    """Integral of `pulse_value` from some fixed time up to `time`."""
    shape, amplitude, since, duration = int(pulse[0]), pulse[1], time - pulse[2], pulse[3]
    if shape == 1:
        times, values = table[0], table[1]
        if time <= times[0]:
            return values[0] * (time - times[0])
        total = 0.0
        for k in range(1, times.shape[0]):
            if time < times[k]:
                return total + 0.5 * (values[k - 1] + pulse_value(time, pulse, table)) * (time - times[k - 1])
            total += 0.5 * (values[k - 1] + values[k]) * (times[k] - times[k - 1])
        return total + values[-1] * (time - times[-1])
    if since < 0.0:
        return 0.0
    if shape == 0:
        return amplitude * since
    if shape == 2:
        return -amplitude * duration * math.expm1(-since / duration)
    if shape == 3:
        return amplitude * duration / math.pi * (1.0 - math.cos(math.pi * min(since / duration, 1.0)))
    if shape == 4:
        return amplitude * min(since, duration)
    return amplitude * (0.5 * since * since / duration if since < duration else since - 0.5 * duration)


@nb.njit(**BY_ADDRESS)
def straight(begin, end, pulse, table):
    """Whether a history is linear between two times."""
    shape, start, stop = int(pulse[0]), pulse[2], pulse[2] + pulse[3]
    if shape == 1:
        bent = False
        for time in table[0]:
            bent = bent or begin < time < end
        return not bent
    if end <= start:
        return True
    if begin < start or shape == 2:
        return False
    return shape == 0 or begin >= stop or (shape != 3 and end <= stop)


@nb.njit(**GUARD)
def pulse_mean(begin, end, pulse, table):
    """Mean of a history between two times, so that its integral does not depend on the steps, however short it is; its value at one time.

    Where it is linear its value in the middle, which has no round-off of a difference.
    """
    if end == begin or straight(begin, end, pulse, table):
        return pulse_value(0.5 * (begin + end), pulse, table)
    return (pulse_integral(end, pulse, table) - pulse_integral(begin, pulse, table)) / (end - begin)
