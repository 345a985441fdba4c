# SPDX-License-Identifier: BSD-3-Clause
"""Runs relievo in a folder of its own and holds what it did against what it promises."""
import json
import math
import os
import re
import resource
import shutil
import signal
import subprocess
import tempfile
import threading
import time

EXIT_CODES = {0, 1, 2, 3, 4, 5, 6, 7, 130}
HANG_S = 10  # Of processor time: a busy machine is no hang.
WAIT_S = 180  # Of the clock, after which a run is given up.
# What libraries and the runtime say; a person gets sentences of ours.
RAW = re.compile(
    r"json\.exception|terminate called|what\(\)|std::|Assertion|TIFF[A-Z][a-z]+:|(Warning|ERROR) \d|"
    r"HDF5-DIAG|Segmentation|Aborted|runtime error|Sanitizer|^libpng|QObject|QPainter|vtk[A-Z]|"
    r"\bpcl::|_tiff\w+|Unknown error|Traceback", re.MULTILINE)


class Run:
    """What one run of the program came to."""

    def __init__(self, arguments, code, out, err, cpu_s, seconds, gave_up):
        self.arguments, self.code, self.out, self.err = arguments, code, out, err
        self.cpu_s, self.seconds, self.gave_up = cpu_s, seconds, gave_up

    def text(self):
        """The command and its answer, for whoever repeats it."""
        words = " ".join(os.fsdecode(word) for word in self.arguments)
        return (words + "\n    exit " + str(self.code) + ", " + f"{self.cpu_s:.1f} s\n    " +
                self.err.decode(errors="backslashreplace").strip()[:600].replace("\n", "\n    "))


class Bed:
    """A program, a home without anything in it, and a place for scratch folders."""

    def __init__(self, program, scratch):
        self.program = os.path.abspath(program)
        self.scratch = scratch
        home = os.path.join(scratch, "home")
        os.makedirs(home, mode=0o700, exist_ok=True)
        self.environment = {
            "PATH": os.environ["PATH"], "HOME": home, "XDG_RUNTIME_DIR": home, "LC_ALL": "C.UTF-8",
            "LIBGL_ALWAYS_SOFTWARE": "1", "TMPDIR": scratch}
        for name in ("DISPLAY", "XAUTHORITY"):
            if name in os.environ:
                self.environment[name] = os.environ[name]

    def folder(self):
        """A new, empty folder; whoever asked for it removes it."""
        return tempfile.mkdtemp(dir=self.scratch, prefix="attack-")

    def start(self, arguments, folder, out, err, program=None, **limits):
        """The running program; its group is its own, so that its children end with it."""

        def in_child():
            os.setsid()
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
            for name, value in limits.items():
                resource.setrlimit(getattr(resource, "RLIMIT_" + name.upper()), (value, value))

        return subprocess.Popen([program or self.program, *arguments], cwd=folder, env=self.environment,
                                stdin=subprocess.DEVNULL, stdout=out, stderr=err,
                                preexec_fn=in_child)

    def run(self, arguments, folder, signal_after=None, **limits):
        """To its end, or until it was waited for in vain.

        signal_after: (seconds, signal) that the program itself is sent, not its children.
        """
        with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as err:
            begin = time.monotonic()
            process = self.start(arguments, folder, out, err, **limits)
            gave_up = threading.Event()

            def give_up():
                gave_up.set()
                kill_group(process.pid)

            watch = [threading.Timer(WAIT_S, give_up)]
            if signal_after is not None:
                watch.append(threading.Timer(signal_after[0], os.kill, (process.pid,
                                                                       signal_after[1])))
            # The process is collected only after both have been called off or have run.
            for timer in watch:
                timer.start()
            os.waitid(os.P_PID, process.pid, os.WEXITED | os.WNOWAIT)
            for timer in watch:
                timer.cancel()
                timer.join()
            _, status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(status)
            seconds = time.monotonic() - begin
            out.seek(0)
            err.seek(0)
            return Run(arguments, process.returncode, out.read(), err.read(),
                       usage.ru_utime + usage.ru_stime, seconds, gave_up.is_set())


def kill_group(pid):
    """Ends a process and all that it started."""
    try:
        os.killpg(pid, signal.SIGKILL)
    except ProcessLookupError:
        pass


def finite(value):
    """No number of a report may be anything else."""
    if isinstance(value, float):
        return math.isfinite(value)
    if isinstance(value, dict):
        return all(finite(part) for part in value.values())
    if isinstance(value, list):
        return all(finite(part) for part in value)
    return True


def refuse_constant(word):
    raise ValueError(word)


def faults_of(run, wants_report):
    """What of a run no user should see, a list of sentences; empty for a good one."""
    faults = []
    err = run.err.decode(errors="backslashreplace")
    if run.gave_up:
        return [f"It had not ended after {WAIT_S} s."]
    if run.code < 0:
        return [f"It was ended by signal {-run.code}."]
    if run.code not in EXIT_CODES:
        faults.append(f"Exit status {run.code} is none of ours.")
    if run.cpu_s > HANG_S:
        faults.append(f"It took {run.cpu_s:.0f} s of processor time.")
    if RAW.search(err):
        faults.append("A library's or the runtime's own message: " + RAW.search(err).group(0))
    # With exit 5 the report says what is not as before.
    if run.code not in (0, 4) and not err.strip() and not run.out.strip():
        faults.append("It failed without a word.")
    if wants_report and run.code in (0, 4):
        try:
            if not finite(json.loads(run.out, parse_constant=refuse_constant)):
                faults.append("The report holds a number that is not finite.")
        except ValueError as error:
            faults.append(f"The report is not JSON: {error}")
    return faults


def contents(folder):
    """Every file under it, with its bytes; names are bytes."""
    found = {}
    top = os.fsencode(folder)
    for parent, _, names in os.walk(top):
        for name in names:
            file = os.path.join(parent, name)
            with open(file, "rb") as stream:
                found[os.path.relpath(file, top)] = stream.read()
    return found


def clear(folder):
    """Removes a scratch folder with all in it."""
    shutil.rmtree(folder, ignore_errors=True)


class Table:
    """What was tried, how often, and what came of it."""

    def __init__(self):
        self.rows, self.faults = [], []

    def add(self, what, tried, faults, note=""):
        """A row, and its faults in full."""
        self.rows.append((what, tried, len(faults), note))
        self.faults += [f"{what}: {fault}" for fault in faults]

    def text(self):
        """As it stands in docs/dev."""
        lines = ["| Attack | Tried | Faults | |", "|---|---|---|---|"]
        lines += [f"| {what} | {tried} | {faults} | {note} |"
                  for what, tried, faults, note in self.rows]
        return "\n".join(lines)
