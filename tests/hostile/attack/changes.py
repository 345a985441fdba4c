# SPDX-License-Identifier: BSD-3-Clause
"""Recordings and packages, changed after they were made: `--verify` has to notice."""
import io
import json
import os
import random
import shutil
import zipfile
from concurrent.futures import ThreadPoolExecutor

import mutate
import seeds
from bed import clear, faults_of


def changed_rows(data, chance):
    """A CSV whose rows are moved, doubled, lost or of another number."""
    lines = data.split(b"\n")
    rows = [n for n, line in enumerate(lines) if line[:1].isdigit() or line[:1] == b"-"]
    at = chance.choice(rows)
    way = chance.randrange(5)
    if way == 0:
        lines[at] = mutate.renumber(lines[at], chance)
    elif way == 1:
        del lines[at]
    elif way == 2:
        lines.insert(at, lines[at])
    elif way == 3:
        lines = lines[:at + 1] + [b""]
    else:
        other = chance.choice(rows)
        lines[at], lines[other] = lines[other], lines[at]
    return b"\n".join(lines)


def changed_zip(data, chance):
    """A package of which one part is another, with sums of the archive that fit."""
    out = io.BytesIO()
    with zipfile.ZipFile(io.BytesIO(data)) as source, zipfile.ZipFile(out, "w") as target:
        names = source.namelist()
        chosen = chance.choice(names)
        for name in names:
            part = source.read(name)
            if name == chosen:
                if chance.random() < 0.2:
                    continue
                part = mutate.bent(part or b" ", chance)
            target.writestr(name, part)
    return out.getvalue()


def parts_of(data):
    """Names and bytes of a zip; None where it is none."""
    try:
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            return {name: archive.read(name) for name in archive.namelist()}
    except (zipfile.BadZipFile, OSError, ValueError, NotImplementedError, EOFError, Exception):
        return None


class Changes:
    """The good files, and what is changed in them."""

    def __init__(self, bed):
        self.bed = bed
        self.made = bed.folder()
        self.faults = seeds.made(bed, self.made)
        self.good = {}
        for name in ("log.csv", "log.h5", "cite.zip"):
            with open(os.path.join(self.made, name), "rb") as stream:
                self.good[name] = stream.read()
        self.consumers = self.consumed("log.h5", self.made)

    def close(self):
        clear(self.made)

    def consumed(self, name, folder):
        """What two readers of a log make of it."""
        outputs = []
        for command in (["replay", name, "-o", "again.csv", "--input", "scan.ply"],
                        ["figure", "scan.ply", "--layout", "plot", "--recording", name, "-o",
                         "again.svg"]):
            run = self.bed.run(command, folder)
            file = os.path.join(folder, command[-1] if command[0] == "figure" else "again.csv")
            data = b""
            if run.code == 0 and os.path.exists(file):
                with open(file, "rb") as stream:
                    data = stream.read()
                os.remove(file)
            outputs.append((run.code, data))
        return outputs

    def bend(self, name, chance):
        good = self.good[name]
        while True:
            data = None
            if name == "log.csv" and chance.random() < 0.6:
                data = changed_rows(good, chance)
            elif name == "cite.zip" and chance.random() < 0.6:
                data = changed_zip(good, chance)
            elif chance.random() < 0.5:
                data = mutate.flip_bits(good, chance)
            else:
                data = mutate.bent(good, chance)
            if data != good and (name != "cite.zip" or parts_of(data) != parts_of(good)):
                return data

    def one(self, seed):
        chance = random.Random(seed)
        name = chance.choice(sorted(self.good))
        folder = self.bed.folder()
        data = self.bend(name, chance)
        shutil.copy(os.path.join(self.made, "scan.ply"), folder)
        with open(os.path.join(folder, name), "wb") as stream:
            stream.write(data)
        command = (["project", "verify", name] if name == "cite.zip" else
                   ["replay", name, "--verify", "--input", "scan.ply"]) + ["--report", "json"]
        run = self.bed.run(command, folder)
        faults = faults_of(run, True)
        if run.code == 0 and not faults and not self.harmless(name, data, run, folder):
            faults.append("The change was not noticed.")
        if run.code in (1, 3, 4, 6, 7):
            faults.append("That is not how a change is told.")
        clear(folder)
        return run.code, [f"seed {seed}: {fault}\n    {run.text()}" for fault in faults]

    def harmless(self, name, data, run, folder):
        """A cut log says that it is one; of HDF5 there are bytes that nobody reads."""
        report = json.loads(run.out)
        if name == "log.csv":
            return report.get("integrity") == "not finished" and self.good[name].startswith(
                data[:data.rfind(b"\n") + 1])
        return name == "log.h5" and (report.get("integrity") == "not finished" or
                                     self.consumed(name, folder) == self.consumers)


def attack(bed, first_seed, count, jobs, table):
    changes = Changes(bed)
    with ThreadPoolExecutor(jobs) as pool:
        results = list(pool.map(changes.one, range(first_seed, first_seed + count)))
    codes = [code for code, _ in results]
    table.add("changed recordings and packages", count,
              changes.faults + [fault for _, faults in results for fault in faults],
              ", ".join(f"{codes.count(code)} exit {code}" for code in sorted(set(codes))))
    changes.close()
