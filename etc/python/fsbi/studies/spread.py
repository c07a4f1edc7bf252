# fsbiFoam | Copyright (C) 2026 the fsbiFoam authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs, some at a time, and how long they take in words.

Threads of the standard library do: what they wait for are programs of their own.
"""

import concurrent.futures


def spread(waiting, jobs, begin, finished, stop):
    """Take all that waits, in its order, `jobs` at a time. begin(item) gives what a
    thread is to do, finished(item, job) takes its result; both are called here, in
    the caller's thread, and may change the list that waits. Whatever ends it before,
    Ctrl-C for one, calls stop, which is to end what runs."""
    pool = concurrent.futures.ThreadPoolExecutor(jobs)
    running = {}
    try:
        while waiting or running:
            while waiting and len(running) < jobs:
                item = waiting.pop(0)
                running[pool.submit(begin(item))] = item
            done, _ = concurrent.futures.wait(
                running, return_when=concurrent.futures.FIRST_COMPLETED, timeout=0.5)
            for job in done:
                finished(running.pop(job), job)
    except BaseException:
        waiting.clear()
        stop()
        raise
    finally:
        pool.shutdown(wait=True)


def duration(seconds):
    if seconds < 100:
        return f"{seconds:.2g} s" if seconds < 10 else f"{seconds:.0f} s"
    minutes = seconds / 60
    return f"{minutes:.0f} min" if minutes < 100 else f"{minutes / 60:.1f} h"
