# SPDX-License-Identifier: BSD-3-Clause
"""Every verb that writes, as a command over outputs that stand already."""
import os
import re
import shutil

import seeds
from bed import clear, contents


class Case:
    """A command from `scan.ply` whose outputs an earlier run from `other.ply` made.

    before: commands that make what it reads. check: a command that must end with 0 where outputs
    hold the time, so that no two runs make them alike; program: whose command it is, if not ours.
    reader: reads the set as one, where there are several outputs, but for those that lie apart.
    """

    def __init__(self, name, command, before=(), check=None, reader=None, program=None, apart=()):
        self.name, self.command, self.before, self.apart = name, command, before, apart
        self.check, self.reader, self.program = check, reader, program


PDF_DATE = re.compile(rb"/CreationDate \(D:\d+")
STROKE = ["--stroke", "stroke.csv", "--frame", "device"]
MAP = ["depthmap", "scan.ply", "-o", "map.tif", "--cells", "500"]
LOG = ["touch", "scan.ply", *STROKE, "-o", "in.csv"]


def converted(ending):
    return Case("convert " + ending, ["convert", "map.tif", "out" + ending], [MAP])


CASES = [
    Case("depthmap", ["depthmap", "scan.ply", "-o", "out.tif", "--quality", "--cells", "700"],
         reader=["info", "out.tif"]),
    Case("depthmap --memory", ["depthmap", "ready.ply", "-o", "out.tif", "--memory", "300",
                               "--spacing", "0.08"],
         [["prepare", "scan.ply", "-o", "ready.ply"]],
         reader=["info", "out.tif"]),
    Case("pyramid", ["pyramid", "map.tif", "-o", "out.tif"], [MAP],
         reader=["info", "out.L0.tif"]),
    Case("fill", ["fill", "map.tif", "-o", "out.tif", "--holes", "membrane"], [MAP],
         reader=["info", "out.tif"]),
    *[converted(ending) for ending in (".tif", ".asc", ".vti", ".ply", ".xyz", ".stl", ".glb")],
    Case("prepare", ["prepare", "scan.ply", "-o", "out.ply", "--thin", "0.2", "--write-recipe",
                     "out.json"]),
    Case("render", ["render", "scan.ply", "-o", "out.png", "--pixels", "700", "--caption",
                    "out.txt", "--window-out", "out.tif"],
         reader=["info", "out.png", "--with", "out.txt"], apart=["out.tif", "out.origin.tif"]),
    Case("figure png", ["figure", "scan.ply", "-o", "out.png", "--caption", "out.txt", "--heights",
                        "out.tif"], reader=["info", "out.png", "--with", "out.txt", "out.tif"]),
    Case("figure pdf", ["figure", "scan.ply", "-o", "out.pdf", "--caption", "out.txt"],
         reader=["info", "out.pdf", "--with", "out.txt"]),
    Case("measure", ["measure", "scan.ply", "--profile", "5,5,50,50", "-o", "out.csv",
                     "--profile-csv", "outp.csv", "--profile-svg", "outp.svg"],
         reader=["info", "outp.svg", "--with", "outp.csv", "out.csv"]),
    Case("touch csv", ["touch", "scan.ply", *STROKE, "-o", "out.csv", "--plot", "out.svg"],
         check=["replay", "out.csv", "--verify", "--input", "scan.ply"],
         reader=["info", "out.csv", "--with", "out.svg"]),
    Case("touch hdf5", ["touch", "scan.ply", *STROKE, "-o", "out.h5"],
         check=["replay", "out.h5", "--verify", "--input", "scan.ply"]),
    Case("record csv", ["record", "scan.ply", "--device", "virtual", "--seconds", "1", "-o",
                        "out.csv"], check=["replay", "out.csv", "--verify"]),
    Case("record hdf5", ["record", "scan.ply", "--device", "virtual", "--seconds", "1", "-o",
                         "out.h5"], check=["replay", "out.h5", "--verify"]),
    Case("replay", ["replay", "in.csv", "-o", "out.csv", "--input", "scan.ply"], [LOG],
         check=["replay", "out.csv", "--verify", "--input", "scan.ply"]),
    Case("project new", ["project", "new", "in.csv", "-o", "out.json"], [LOG],
         check=["project", "check", "out.json"]),
    Case("project package", ["project", "package", "in.json", "-o", "out.zip"],
         [LOG, ["project", "new", "in.csv", "-o", "in.json"]],
         check=["project", "verify", "out.zip"]),
    Case("video", ["video", "in.csv", "-o", "out.mp4", "--input", "scan.ply", "--size", "320x240",
                   "--fps", "10"], [LOG], ["-v", "error", "-i", "out.mp4", "-f", "null", "-"],
         program="ffmpeg"),
]


def mirrored(command):
    """The same, from the other scan."""
    return ["other.ply" if word == "scan.ply" else word for word in command]


def timeless(data):
    """A PDF holds the second at which it was made."""
    return data and PDF_DATE.sub(b"", data)


class Stage:
    """The folder a case begins from, and what its outputs are before and after it."""

    def __init__(self, bed, case):
        self.bed, self.case = bed, case
        self.faults = []
        self.template = bed.folder()
        seeds.base(self.template, 160)
        for command in case.before:
            self.must_run(command, self.template)
        self.inputs = contents(self.template)
        self.new, self.seconds = self.outcome(case.command)
        self.old = self.make_old()
        self.names = set(self.inputs) | set(self.new)

    def must_run(self, command, folder):
        run = self.bed.run(command, folder)
        if run.code not in (0, 4):
            self.faults.append("It did not run undisturbed: " + run.text())
        return run

    def outcome(self, command):
        folder = self.fresh()
        run = self.must_run(command, folder)
        made = {name: data for name, data in contents(folder).items() if name not in self.inputs}
        self.faults += [f"It left {os.fsdecode(name)}." for name in made if name.startswith(b".")]
        clear(folder)
        return made, run.seconds

    def make_old(self):
        """Outputs of the other scan, beside the inputs of this one."""
        folder = self.bed.folder()
        seeds.base(folder, 160)
        for command in self.case.before:
            self.must_run(mirrored(command), folder)
        self.must_run(mirrored(self.case.command), folder)
        made = {name: data for name, data in contents(folder).items() if name not in self.inputs}
        for name, data in made.items():
            with open(os.path.join(os.fsencode(self.template), name), "wb") as stream:
                stream.write(data)
        clear(folder)
        return made

    def fresh(self):
        """A copy of where it begins."""
        folder = self.bed.folder()
        shutil.copytree(self.template, folder, dirs_exist_ok=True)
        return folder

    def state_of(self, name, data):
        """'old', 'new' or 'changed'; what holds the time is checked by a command."""
        data = timeless(data)
        if data == timeless(self.old.get(name)):
            return "old"
        if data == timeless(self.new.get(name)) or (self.case.check and data):
            return "new"
        return "changed"

    def judge(self, folder):
        """Faults of what stands in the folder now: lost, half, foreign or mixed outputs."""
        faults = []
        now = contents(folder)
        for name, data in self.inputs.items():
            if now.get(name) != data:
                faults.append(f"The input {os.fsdecode(name)} was changed.")
        states = {}
        for name in set(self.old) | set(self.new):
            if name not in now:
                if name in self.old and name in self.new:
                    faults.append(f"The earlier {os.fsdecode(name)} is lost.")
                continue
            states[name] = self.state_of(name, now[name])
            if states[name] == "changed":
                faults.append(f"{os.fsdecode(name)} is neither the earlier nor the new one.")
        if self.case.check and "new" in states.values() and not faults:
            run = self.bed.run(self.case.check, folder, program=self.case.program)
            if run.code != 0:
                faults.append("What was written does not verify: " + run.text())
        return faults + self.mixed(states, folder)

    def mixed(self, states, folder):
        """A set of which one part is of the earlier run has to be noticed by whoever reads it."""
        of_set = {state for name, state in states.items() if os.fsdecode(name) not in self.case.apart}
        if not self.case.reader or len(of_set) < 2:
            return []
        run = self.bed.run(self.case.reader, folder)
        if run.code != 0 or b"was not written with" in run.err:
            return []
        parts = ", ".join(f"{os.fsdecode(name)} {state}" for name, state in sorted(states.items()))
        return [f"Earlier and new outputs stand beside each other unnoticed: {parts}."]

    def strange(self, folder):
        """Names that neither were there nor are outputs; an unfinished log is left on purpose."""
        return sorted(os.fsdecode(name) for name in set(contents(folder)) - self.names
                      if b".unfinished" not in name)

    def close(self):
        clear(self.template)
