# SPDX-License-Identifier: BSD-3-Clause
"""Signals at random moments of every verb that writes, and one run without any."""
import random
import signal
from concurrent.futures import ThreadPoolExecutor

from bed import clear
from cases import CASES, Stage

SIGNALS = [signal.SIGKILL, signal.SIGKILL, signal.SIGTERM, signal.SIGINT, signal.SIGHUP]


def moment(chance, seconds):
    """Half of them late, where the outputs are written and renamed."""
    share = chance.uniform(0.6, 1.1) if chance.random() < 0.5 else chance.uniform(0, 1.1)
    return share * seconds


def undisturbed(stage):
    """However slow the machine has become since the moments were chosen, this one comes to its end.

    @return faults
    """
    folder = stage.fresh()
    run = stage.must_run(stage.case.command, folder)
    faults = stage.judge(folder)
    left = stage.strange(folder)
    if left:
        faults.append("It left " + ", ".join(left) + ".")
    clear(folder)
    return [f"without a signal: {fault}\n    {run.text()}" for fault in faults]


def one(stage, seed):
    """@return faults"""
    chance = random.Random(seed)
    sent = chance.choice(SIGNALS)
    folder = stage.fresh()
    run = stage.bed.run(stage.case.command, folder,
                        signal_after=(moment(chance, stage.seconds), sent))
    faults = []
    if run.gave_up:
        faults.append("It did not end.")
    if run.code not in (0, 4, 130, -sent):
        faults.append(f"It ended with {run.code}.")
    faults += stage.judge(folder)
    left = stage.strange(folder)
    if sent == signal.SIGKILL and left:
        # Nothing can tidy up at that moment; the next run in this folder does.
        stage.bed.run(stage.case.command, folder)
        left = stage.strange(folder)
    if left:
        faults.append("It left " + ", ".join(left) + ".")
    clear(folder)
    name = signal.Signals(sent).name
    return [f"seed {seed}, {name}: {fault}\n    {run.text()}" for fault in faults]


def attack(bed, first_seed, count, jobs, table, only=None):
    """`count` over all cases, in turn."""
    cases = [case for case in CASES if not only or only in case.name]
    for index, case in enumerate(cases):
        share = count // len(cases) + (1 if index < count % len(cases) else 0)
        if share == 0:
            continue
        stage = Stage(bed, case)
        first = first_seed + 100000 * index
        with ThreadPoolExecutor(jobs) as pool:
            results = list(pool.map(lambda seed, at=stage: one(at, seed),
                                    range(first, first + share)))
        results.append(undisturbed(stage))
        table.add(f"kills: {case.name}", share,
                  stage.faults + [fault for faults in results for fault in faults])
        stage.close()
