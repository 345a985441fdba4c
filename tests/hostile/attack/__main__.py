#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Attacks the command line: mutated files, kills, full disks, changed recordings, bad options.

python3 tests/hostile/attack RELIEVO GOOD_FILES [--seed N] [--files 5000] [--kills 500] [--disks 10]
[--changes 1000] [--options] [--mixed] [--only NAME] [--table TABLE.md]

RELIEVO is the program, GOOD_FILES the one that writes a good file of every format
(build/release/tests/hostile_good_files). What is not asked for is not done. Every fault is printed
with its seed and command; the exit status is 1 if there is any. The same seed gives the same files,
commands and, but for how busy the machine is, moments.
"""
import argparse
import os
import sys
import tempfile

import changes
import disks
import kills
import mixed
import mutated
import options
from bed import Bed, Table, clear


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("relievo")
    parser.add_argument("good_files")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    for name in ("files", "kills", "disks", "changes"):
        parser.add_argument("--" + name, type=int, default=0)
    parser.add_argument("--options", action="store_true")
    parser.add_argument("--mixed", action="store_true")
    parser.add_argument("--only", help="cases of kills and disks, or the verb of options")
    parser.add_argument("--table", help="also writes the table there")
    return parser.parse_args()


def main():
    asked = arguments()
    # Before any thread begins: they would not follow to where disks are mounted.
    mounts = asked.disks > 0 and disks.may_mount()
    table = Table()
    with tempfile.TemporaryDirectory() as scratch:
        bed = Bed(asked.relievo, scratch)
        if asked.files:
            folder = bed.folder()
            mutated.Mutated(bed, os.path.abspath(asked.good_files), folder).attack(
                asked.seed, asked.files, asked.jobs, table)
            clear(folder)
        if asked.options:
            options.attack(bed, asked.jobs, table, asked.only)
        if asked.changes:
            changes.attack(bed, asked.seed, asked.changes, asked.jobs, table)
        if asked.mixed:
            mixed.attack(bed, table, asked.only)
        if asked.kills:
            kills.attack(bed, asked.seed, asked.kills, asked.jobs, table, asked.only)
        if mounts:
            disks.attack(bed, disks.SHARES[:asked.disks], table, asked.only)
        elif asked.disks:
            print("Full disks are skipped: this account may not mount any.")
    for fault in table.faults:
        print(fault)
    print(table.text())
    if asked.table:
        with open(asked.table, "w", encoding="utf-8") as stream:
            stream.write(table.text() + "\n")
    return 1 if table.faults else 0


if __name__ == "__main__":
    sys.exit(main())
