#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""open_scans.py opens scans one after the other, and leaves no program behind when it is killed.

open_scans_test.py OPEN_SCANS RELIEVO SCAN
"""
import os
import signal
import subprocess
import sys
import tempfile
import time


def children(pid):
    """Processes that `pid` started."""
    found = []
    for name in os.listdir("/proc"):
        try:
            with open("/proc/" + name + "/stat", encoding="latin1") as stat:
                if int(stat.read().rsplit(")", 1)[1].split()[1]) == pid:
                    found.append(int(name))
        except (OSError, ValueError):
            pass
    return found


def runs(pid):
    try:
        with open("/proc/" + str(pid) + "/stat", encoding="latin1") as stat:
            return stat.read().rsplit(")", 1)[1].split()[0] != "Z"
    except OSError:
        return False


def wait_for(what, condition):
    while not condition():  # The test's own time limit ends this.
        time.sleep(0.05)
    print(what, flush=True)


def main():
    script, relievo, scan = sys.argv[1:4]
    with tempfile.TemporaryDirectory() as out:
        command = [sys.executable, script, relievo, out, scan, scan]
        result = subprocess.run(command + ["--size", "900x600"], stdout=subprocess.PIPE, check=True)
        assert result.stdout.decode().count(" open\n") == 2, result.stdout
        pictures = os.listdir(out)
        assert len(pictures) == 1 and os.path.getsize(os.path.join(out, pictures[0])) > 10000
        for end in (signal.SIGTERM, signal.SIGKILL):
            running = subprocess.Popen(command, stdout=subprocess.DEVNULL)
            wait_for("a screen and the program run", lambda: len(children(running.pid)) == 2)
            started = children(running.pid)
            running.send_signal(end)
            running.wait()
            wait_for("neither is left", lambda: not any(runs(pid) for pid in started))


if __name__ == "__main__":
    main()
