# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""What adhering bodies do: do they stay together, do they roll, do they pause?

    time, speed = relative_speed(history, "tumourCell", "leukocyte", interval=30)
    mean = moving_mean(speed, 75)
    start = aggregate_time(time, mean, below=0.05 * speed[0])   # nan: never
    motion = rolling(time, x, free=6.2e-4, window=500)
    motion.mean, motion.pause_fraction, motion.pauses
    low, high = wilson(3, 8)        # of the probability, 3 of 8 happened
"""

import collections
import math

import numpy as np

Rolling = collections.namedtuple("Rolling", "mean pause_fraction pauses time speed")


def uniform(time, values, interval):
    """Values at equal intervals from the first time on: steps of a run are as
    long as they like, means over samples need equal ones."""
    count = int(math.floor((time[-1] - time[0]) / interval * (1 + 1e-12))) + 1
    at = time[0] + interval * np.arange(count)
    return at, np.interp(at, time, values)


def relative_speed(history, body, other, interval):
    """Times and |velocity of body - velocity of other| at equal intervals."""
    a, b = (history[f"bodies/{name}/velocity"].array for name in (body, other))
    speed = np.linalg.norm(a[:, 1:] - b[:, 1:], axis=1)
    return uniform(a[:, 0], speed, interval)


def moving_mean(values, samples):
    """Mean of the last `samples` values; of fewer at the beginning."""
    total = np.concatenate(([0], np.cumsum(values)))
    last = np.arange(1, len(values) + 1)
    first = np.maximum(last - samples, 0)
    return (total[last] - total[first]) / (last - first)


def aggregate_time(time, mean, below):
    """From when on the mean stays below a bound until the end; nan: it does
    not."""
    above = np.flatnonzero(~(np.asarray(mean) < below))
    first = above[-1] + 1 if len(above) else 0
    return float(time[first]) if first < len(mean) else math.nan


def intervals(time, mask):
    """First and last times of the runs of True."""
    edges = np.flatnonzero(np.diff(np.concatenate(([0], np.asarray(mask, int), [0]))))
    return [(float(time[i]), float(time[j - 1])) for i, j in zip(edges[::2], edges[1::2])]


def rolling(time, x, free, window, pause=0.1):
    """Mean velocity, the part of the time in pauses, and the pauses. A pause:
    the mean velocity over a window is below pause*free, free being that
    without adhesion. Taken from where the body is, which bonds that form and
    break within a step do not disturb."""
    time, x = np.asarray(time), np.asarray(x)
    middle, _ = uniform(time, x, window / 4)
    middle = middle[(middle >= time[0] + window / 2) & (middle <= time[-1] - window / 2)]
    ends = [np.interp(middle + sign * window / 2, time, x) for sign in (-1, 1)]
    speed = (ends[1] - ends[0]) / window
    slow = speed < pause * free
    mean = (x[-1] - x[0]) / (time[-1] - time[0])
    return Rolling(mean, float(np.mean(slow)), intervals(middle, slow), middle, speed)


def wilson(happened, trials, z=1.96):
    """Band of a probability, of 95 % confidence unless told: Wilson's score
    interval, which is meaningful for few trials and for 0 and all."""
    p = happened / trials
    scale = 1 / (1 + z * z / trials)
    centre = scale * (p + z * z / (2 * trials))
    half = scale * z * math.sqrt(p * (1 - p) / trials + (z / (2 * trials)) ** 2)
    # without the last digit's error where it is exact
    return (max(0.0, centre - half) if happened else 0.0,
            min(1.0, centre + half) if happened < trials else 1.0)
