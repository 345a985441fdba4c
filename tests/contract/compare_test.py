#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""compare_test.py RELIEVO: compare.py finds nothing between a program and itself, and each of these faults."""
import sys
import tempfile
from pathlib import Path

from compare import COMMANDS, ROOT, differences

SCAN = ROOT / "data/samples/relief_f.ply"
NAMES = ("info", "depthmap cells", "depthmap tiles", "touch", "convert asc", "render", "no such option")
# What stands in for the program: a shell script that changes one thing. "$R" is the program.
FAULTS = {
    "exit code": '"$R" "$@"; e=$?; [ $e = 1 ] && exit 2; exit $e',
    "report": '"$R" "$@" | sed "s/\\"points\\": */\\"points\\": 1/"; exit ${PIPESTATUS[0]}',
    "message": '"$R" "$@"; e=$?; echo more >&2; exit $e',
    "heights": 'case $1 in depthmap) "$R" "$@" --unit cm;; *) "$R" "$@";; esac',
    "a file more": '"$R" "$@"; e=$?; [ -d out ] && touch out/more; exit $e',
    "log": '"$R" "$@"; e=$?; [ -f out/log.csv ] && sed -i "/^[0-9]/ s/0/1/" out/log.csv; exit $e',
    "pixels": 'case $1 in render) "$R" "$@" --colour viridis;; *) "$R" "$@";; esac',
}


def main():
    program = Path(sys.argv[1]).resolve()
    commands = [c for c in COMMANDS if c[0] in NAMES]
    assert len(commands) == len(NAMES)
    said = []
    found, run, files = differences(program, program, [SCAN], commands, said.append)
    assert found == 0, "\n".join(said)
    assert run == len(NAMES) and files >= 8, (run, files)
    found, _, _ = differences(program, program, [SCAN], commands, said.append, only=True)
    assert found == 0, "\n".join(said)
    for fault, script in FAULTS.items():
        with tempfile.TemporaryDirectory() as bed:
            other = Path(bed) / "relievo"
            other.write_text(f"#!/bin/bash\nR={program}\n{script}\n")
            other.chmod(0o755)
            found, _, _ = differences(program, other, [SCAN], commands, said.append)
            assert found > 0, f"the planted fault was not found: {fault}"
            if fault not in ("message", "a file more"):  # Which a later version may have.
                found, _, _ = differences(program, other, [SCAN], commands, said.append, only=True)
                assert found > 0, f"the planted fault was not found in what is kept: {fault}"
            print(f"{fault}: {found} differences")


if __name__ == "__main__":
    main()
