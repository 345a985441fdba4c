# SPDX-License-Identifier: BSD-3-Clause
"""Mutated files of every format that is read or written, each given to a verb that opens it."""
import json
import os
import random
import shutil
from concurrent.futures import ThreadPoolExecutor

import mutate
import seeds
from bed import clear, faults_of

SCAN_VERBS = [
    lambda name: ["info", name, "--report", "json"],
    lambda name: ["info", name, "--report", "json"],
    lambda name: ["depthmap", name, "-o", "out.tif", "--report", "json"],
    lambda name: ["depthmap", name, "-o", "out.tif", "--report", "json", "--load-incomplete"],
    lambda name: ["depthmap", name, "-o", "out.tif", "--report", "json", "--cells", "50",
                  "--view", "top", "--reader", "own"],
    lambda name: ["depthmap", name, "-o", "out.tif", "--report", "json", "--memory", "300",
                  "--spacing", "0.5", "--view", "top"],
    lambda name: ["prepare", name, "-o", "out.ply", "--report", "json", "--thin", "0.5"],
]
# What each name is opened by, beside the scans; `{}` is the mutated file.
OTHER_VERBS = {
    "log.csv": [["replay", "{}", "--verify", "--report", "json"],
                ["figure", "scan.ply", "--layout", "plot", "--recording", "{}", "-o", "out.svg"]],
    "log.h5": [["replay", "{}", "--verify", "--report", "json"]],
    "work.relievo.json": [["project", "check", "{}", "--report", "json"],
                          ["project", "info", "{}", "--report", "json"],
                          ["project", "package", "{}", "-o", "out.zip"]],
    "cite.zip": [["project", "verify", "{}", "--report", "json"],
                 ["replay", "{}", "--verify", "--report", "json"]],
    "recipe.json": [["prepare", "scan.ply", "--recipe", "{}", "-o", "out.ply", "--report", "json"]],
    "stroke.csv": [["touch", "scan.ply", "--stroke", "{}", "--frame", "device", "-o", "out.csv",
                    "--report", "json"]],
    "picture.png": [["render", "scan.ply", "--from-image", "{}", "-o", "out.png"],
                    ["info", "{}", "--report", "json"]],
    "map.tif": [["info", "{}", "--report", "json"], ["measure", "{}", "--point", "30,30",
                                                     "--report", "json"],
                ["pyramid", "{}", "-o", "out.tif", "--report", "json"],
                ["convert", "{}", "out.xyz"]],
    "map.origin.tif": [["measure", "map.tif", "--point", "30,30", "--report", "json"]],
    "map.colour.tif": [["convert", "map.tif", "out.ply"]],
    "map.count.tif": [["measure", "map.tif", "--point", "30,30", "--report", "json"],
                      ["info", "map.tif", "--with", "{}", "--report", "json"]],
}


def sane(run):
    """Faults of a report that is JSON and still says what cannot be."""
    report = json.loads(run.out)
    faults = []
    if report.get("finite_points", 0) > report.get("points", 1 << 64):
        faults.append("More points are finite than there are.")
    shares = report.get("shares")
    if shares and abs(sum(shares.values()) - 1) > 1e-6:
        faults.append("The shares do not add up to 1.")
    heights = report.get("height_mm")
    if heights and heights["min"] is not None and heights["min"] > heights["max"]:
        faults.append("The lowest height is above the highest.")
    return faults


class Mutated:
    """`count` of them from a seed; the same seed gives the same files in the same order."""

    def __init__(self, bed, good_program, folder):
        self.bed = bed
        self.made = os.path.join(folder, "made")
        self.good = os.path.join(folder, "good")
        os.makedirs(self.made)
        os.makedirs(self.good)
        self.faults = seeds.made(bed, self.made)
        self.scans = seeds.good_files(good_program, self.good)

    def choice(self, chance):
        """@return folder of the good file, its name, and the command with the mutated file in it"""
        if chance.random() < 0.6:
            name = chance.choice(self.scans)
            return self.good, name, chance.choice(SCAN_VERBS)(name)
        name = chance.choice(sorted(OTHER_VERBS))
        command = [word.replace("{}", name) for word in chance.choice(OTHER_VERBS[name])]
        return self.made, name, command

    def one(self, seed):
        chance = random.Random(seed)
        source, name, command = self.choice(chance)
        folder = self.bed.folder()
        if source == self.made:
            shutil.copytree(self.made, folder, dirs_exist_ok=True)
        with open(os.path.join(source, name), "rb") as stream:
            data = mutate.bent(stream.read(), chance)
        with open(os.path.join(folder, name), "wb") as stream:
            stream.write(data)
        before = set(os.listdir(folder))
        run = self.bed.run(command, folder)
        wants_report = "json" in command
        faults = faults_of(run, wants_report)
        after = set(os.listdir(folder)) - before
        if run.code not in (0, 4, 5) and after:
            faults.append("It failed and left " + ", ".join(sorted(after)) + ".")
        if not faults and wants_report and run.code in (0, 4):
            faults += sane(run)
        clear(folder)
        return run.code, [f"seed {seed}: {fault}\n    {run.text()}" for fault in faults]

    def attack(self, first_seed, count, jobs, table):
        with ThreadPoolExecutor(jobs) as pool:
            results = list(pool.map(self.one, range(first_seed, first_seed + count)))
        codes = [code for code, _ in results]
        note = ", ".join(f"{codes.count(code)} exit {code}" for code in sorted(set(codes)))
        table.add("mutated files", count,
                  self.faults + [fault for _, faults in results for fault in faults], note)
