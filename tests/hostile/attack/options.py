# SPDX-License-Identifier: BSD-3-Clause
"""Every option of every verb with texts that are no number, or one that nothing can be done with."""
import os
import re
import shutil
from concurrent.futures import ThreadPoolExecutor

import seeds
from bed import clear, contents, faults_of

NUMBERS = ["nan", "inf", "-inf", "-1", "0", "1e308", "-1e308", "1e-300", "", " ", "1e999", "0x10", "1,5",
           "1;2", "--", "\u0663", "9223372036854775808", "1e5"]
OPTION = re.compile(r"^  (?:-\w,)?--([a-z-]+) (?:TEXT|INT|FLOAT)", re.MULTILINE)
# What each verb needs to do anything at all; short runs.
BASES = {
    "info": ["scan.ply"],
    "prepare": ["scan.ply", "-o", "out.ply"],
    "depthmap": ["scan.ply", "-o", "out.tif"],
    "fill": ["map.tif", "-o", "out.tif"],
    "pyramid": ["map.tif", "-o", "out.tif"],
    "convert": ["map.tif", "out.ply"],
    "publish": ["map.tif", "-o", "out", "--licence", "CC0-1.0", "--citation", "none"],
    "render": ["map.tif", "-o", "out.png", "--pixels", "32"],
    "figure": ["map.tif", "-o", "out.svg"],
    "measure": ["map.tif", "--point", "30,30"],
    "suggest": ["map.tif"],
    "describe": ["map.tif"],
    "touch": ["map.tif", "--stroke", "stroke.csv", "--frame", "device", "-o", "out.csv"],
    "record": ["map.tif", "--device", "virtual", "--seconds", "0.1", "-o", "out.csv"],
    "replay": ["log.csv", "-o", "out.csv"],
    "devices": ["selftest"],
    "sound": ["log.csv", "-o", "out.wav"],
    "video": ["log.csv", "-o", "out.mp4", "--size", "64x64", "--fps", "5", "--to", "0.2"],
}
# Other options that this one only goes with.
WITH = {"eye-angle": ["--stereo", "half"], "zero-plane": ["--stereo", "half"],
        "soft": ["--preset", "smooth"], "tick": ["--preset", "smooth"],
        "magnet-reach": ["--magnet", "0.5"], "plate": ["--frame", "view"],
        "rounds": ["--guide", "outline", "--device", "virtual"],
        "plane": ["--area", "10,10;20,10;20,20"]}
# Texts, not numbers: any name is a good name.
NAMES = {"output", "caption", "heights", "window-out", "profile-csv", "profile-svg", "section-csv",
         "section-svg", "write-recipe", "plot", "licence", "citation", "title"}
NOT_FINITE = re.compile(rb"(?<![\w.])-?(nan|inf(inity)?)(?![\w.])", re.IGNORECASE)


def options_of(bed, verb, folder):
    run = bed.run([verb, "--help"], folder)
    return sorted(set(OPTION.findall(run.out.decode())) - NAMES - {"report", "device"})


def without(words, option):
    """The base without this option, where it has it."""
    flag = "--" + option
    if flag not in words:
        return words
    at = words.index(flag)
    return words[:at] + words[at + 2:]


def bad_rows(folder, before):
    """Rows that hold what is no number. Maps hold NaN outside the object, so tables only."""
    faults = []
    for name, data in contents(folder).items():
        if name in before or not name.endswith(b".csv"):
            continue
        rows = b"\n".join(line for line in data.split(b"\n") if not line.startswith(b"#"))
        found = NOT_FINITE.search(rows)
        if found:
            faults.append(f"{os.fsdecode(name)} holds '{found.group(0).decode()}'.")
    return faults


def one(bed, made, verb, option, value):
    """@return faults"""
    folder = bed.folder()
    for name in ("scan.ply", "map.tif", "map.origin.tif", "stroke.csv", "log.csv"):
        shutil.copy(os.path.join(made, name), folder)
    before = contents(folder)
    command = [verb, *without(BASES[verb], option), *WITH.get(option, []), f"--{option}={value}",
               "--report", "json"]
    run = bed.run(command, folder)
    faults = faults_of(run, verb not in ("render", "video"))
    strange = sorted(os.fsdecode(name) for name in set(contents(folder)) - set(before))
    if run.code not in (0, 4) and strange:
        faults.append("It was refused and left " + ", ".join(strange) + ".")
    hidden = [name for name in strange if name.startswith(".")]
    if hidden:
        faults.append("It left " + ", ".join(hidden) + ".")
    if any(data != before[name] for name, data in contents(folder).items() if name in before):
        faults.append("An input was changed.")
    if value.strip().lower() in ("nan", "inf", "-inf", "", "1e999") and run.code in (0, 4):
        faults.append("It was taken.")
    faults += bad_rows(folder, before)
    clear(folder)
    return run.code, [f"{fault}\n    {run.text()}" for fault in faults]


def attack(bed, jobs, table, only=None):
    """All of them, verb by verb."""
    made = bed.folder()
    start = seeds.made(bed, made)
    for verb in BASES:
        if only and only != verb:
            continue
        tried = [(option, value) for option in options_of(bed, verb, made) for value in NUMBERS]
        with ThreadPoolExecutor(jobs) as pool:
            results = list(pool.map(lambda words, of=verb: one(bed, made, of, *words), tried))
        taken = sum(1 for code, _ in results if code in (0, 4))
        table.add(f"options: {verb}", len(tried),
                  start + [fault for _, faults in results for fault in faults], f"{taken} were taken")
        start = []
    clear(made)
