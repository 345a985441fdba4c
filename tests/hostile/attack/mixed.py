# SPDX-License-Identifier: BSD-3-Clause
"""One file of every set replaced by the one that an earlier run made: the reader has to notice."""
import os

import cases
from bed import clear


def replaced(stage, name):
    """A folder with the new outputs, but for one."""
    folder = stage.fresh()
    for other, data in stage.new.items():
        with open(os.path.join(os.fsencode(folder), other), "wb") as stream:
            stream.write(stage.old[other] if other == name else data)
    return folder


def attack(bed, table, only=None):
    for case in cases.CASES:
        if not case.reader or (only and only not in case.name):
            continue
        stage = cases.Stage(bed, case)
        faults = list(stage.faults)
        differing = [name for name in stage.new
                     if name in stage.old and os.fsdecode(name) not in case.apart and
                     cases.timeless(stage.new[name]) != cases.timeless(stage.old[name])]
        for name in differing:
            folder = replaced(stage, name)
            states = {other: "old" if other == name else "new" for other in differing}
            faults += stage.mixed(states, folder)
            clear(folder)
        table.add(f"mixed sets: {case.name}", len(differing), faults)
        stage.close()
