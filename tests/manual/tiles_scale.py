#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Maps by several processes, by hand: equal files, times, memory, kills, and a forecast.

    tiles_scale.py RELIEVO_TILES FOLDER compare [--points 1e8] [--ranks 1,2,3,4] [--threads 1,2,4]
    tiles_scale.py RELIEVO_TILES FOLDER kill    [--points 1e8] [--kills 10] [--seed 1]
    tiles_scale.py RELIEVO_TILES FOLDER model

FOLDER takes the scan (20 bytes a point), the maps, and figures.json, which `compare` writes and
`model` reads. The scan is made by a counter-based generator: a site with waves, a wall and an empty
disc, in rows of a flight. Needs mpirun and NumPy.
"""

import argparse
import hashlib
import json
import os
import pathlib
import random
import struct
import subprocess
import sys
import time

import numpy

SCALE_MM = 0.001
POINTS_A_CELL = 2.5  # As the program proposes cells.


def make_scan(file, points):
    """LAS 1.2, point format 0, rows of a flight: y grows with the number of the point."""
    side = (points / POINTS_A_CELL) ** 0.5  # Cells of 1 mm.
    head = bytearray(227)
    head[0:4] = b"LASF"
    head[24:26] = bytes((1, 2))
    struct.pack_into("<HII", head, 94, 227, 227, 0)
    struct.pack_into("<BHI", head, 104, 0, 20, points)
    struct.pack_into("<6d", head, 131, SCALE_MM, SCALE_MM, SCALE_MM, 0, 0, 0)
    struct.pack_into("<6d", head, 179, side, 0, side, 0, 200, 0)
    record = [("x", "<i4"), ("y", "<i4"), ("z", "<i4"), ("intensity", "<u2"), ("rest", "u1", 6)]
    at_once = 2_000_000
    with open(file, "wb") as out:
        out.write(head)
        for first in range(0, points, at_once):
            count = min(at_once, points - first)
            draw = numpy.random.Generator(numpy.random.Philox(key=first))
            x = draw.random(count) * side
            y = (first + numpy.sort(draw.random(count)) * count) / points * side
            z = 100 + 30 * numpy.sin(x / 300) * numpy.cos(y / 400) + 3 * numpy.sin(x / 20)
            z += numpy.where(x > 0.6 * side, 15, 0)
            x = numpy.where(numpy.hypot(x - 0.3 * side, y - 0.5 * side) < 0.04 * side, 0.5 * x, x)
            rows = numpy.zeros(count, dtype=record)
            for name, value in (("x", x), ("y", y), ("z", z)):
                rows[name] = numpy.round(value / SCALE_MM)
            out.write(rows.tobytes())


def scan_of(folder, points):
    file = folder / f"scan_{points:.0e}.las"
    if not file.exists() or file.stat().st_size != 227 + 20 * points:
        make_scan(file, points)
    return file


def sum_of(folder, stem):
    total = hashlib.sha256()
    for file in sorted(folder.glob(stem + "*.tif")):
        total.update(file.name[len(stem):].encode())
        with open(file, "rb") as content:
            while block := content.read(1 << 22):
                total.update(block)
    return total.hexdigest()[:16]


def environment():
    return dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                OMPI_MCA_btl_vader_single_copy_mechanism="none",
                OMPI_MCA_rmaps_base_oversubscribe="1", OMPI_MCA_hwloc_base_binding_policy="none")


def start(program, folder, scan, ranks, threads, stem):
    words = ["mpirun", "-q", "-n", str(ranks), program, str(scan), "--unit", "mm", "--view", "top",
             "--spacing", "1", "--threads", str(threads), "--memory", "2000", "--job",
             str(folder / "job"), "-o", str(folder / (stem + ".tif")), "--report", "json"]
    return subprocess.Popen(words, stdout=open(folder / "report.json", "w"),
                            stderr=open(folder / "said.txt", "w"), env=environment())


def tiles_of(mpirun):
    """Processes that it started."""
    try:
        with open(f"/proc/{mpirun}/task/{mpirun}/children") as children:
            return [int(child) for child in children.read().split()]
    except OSError:
        return []


def highest_mb(pid):
    try:
        with open(f"/proc/{pid}/status") as status:
            for line in status:
                if line.startswith("VmHWM"):
                    return int(line.split()[1]) / 1000
    except OSError:
        pass
    return 0.0


def run(program, folder, scan, ranks, threads, stem):
    """One map; its report, with seconds of the whole and the highest memory of a process."""
    began = time.monotonic()
    process = start(program, folder, scan, ranks, threads, stem)
    most = 0.0
    while process.poll() is None:
        most = max([most] + [highest_mb(pid) for pid in tiles_of(process.pid)])
        time.sleep(0.02)
    if process.returncode != 0:
        sys.exit(f"exit code {process.returncode}: {(folder / 'said.txt').read_text()}")
    report = json.loads((folder / "report.json").read_text())
    report["whole_s"] = time.monotonic() - began
    report["most_mb"] = most
    return report


def compare(program, folder, options):
    scan = scan_of(folder, options.points)
    figures, once = [], None
    print("| processes | threads each | s | MB of the largest | told, MB | files |")
    print("|---:|---:|---:|---:|---:|---|")
    for ranks in options.ranks:
        for threads in options.threads:
            for old in folder.glob("map*.tif"):
                old.unlink()
            report = run(program, folder, scan, ranks, threads, "map")
            total = sum_of(folder, "map")
            once = once or total
            equal = "equal" if total == once else "DIFFER"
            told = report["exchanged_bytes"] / 1e6
            print(f"| {ranks} | {threads} | {report['whole_s']:.1f} | {report['most_mb']:.0f} "
                  f"| {told:.1f} | {equal} |", flush=True)
            figures.append({"points": options.points, "ranks": ranks, "threads": threads,
                            "cells": report["cells"][0] * report["cells"][1],
                            "whole_s": report["whole_s"], "most_mb": report["most_mb"],
                            "told": report["exchanged_bytes"], "seconds": report["seconds"],
                            "sum": total})
    file = folder / "figures.json"
    known = json.loads(file.read_text()) if file.exists() else []
    file.write_text(json.dumps(known + figures, indent=1))
    if any(figure["sum"] != once for figure in figures):
        sys.exit("The files differ.")


def kill(program, folder, options):
    scan = scan_of(folder, options.points)
    draw = random.Random(options.seed)
    report = run(program, folder, scan, 2, 1, "once")
    whole, once = report["whole_s"], sum_of(folder, "once")
    print(f"seed {options.seed}; one run by two processes: {whole:.1f} s, {once}")
    print("| killed after, s | of | gone on by | points taken over | rows | filled | s | files |")
    print("|---:|---:|---:|---:|---:|---:|---:|---|")
    differ = 0
    for _ in range(options.kills):
        for old in folder.glob("map*.tif"):
            old.unlink()
        ranks, then = draw.choice((1, 2, 3)), draw.uniform(0.05, 0.95) * whole
        process = start(program, folder, scan, ranks, 1, "map")
        time.sleep(then)
        victims = tiles_of(process.pid)
        if victims:
            os.kill(draw.choice(victims), 9)
        process.wait()
        after = draw.choice((1, 2, 3))
        report = run(program, folder, scan, after, 1, "map")
        over = report["taken_over"]
        total = sum_of(folder, "map")
        differ += total != once
        print(f"| {then:.1f} | {ranks} | {after} | {over['points'] / options.points:.0%} "
              f"| {over['rows_of_tiles']} | {over['filled_rows_of_tiles']} "
              f"| {report['whole_s']:.1f} | {'equal' if total == once else 'DIFFER'} |", flush=True)
    if differ:
        sys.exit("The files differ.")


def phases_of(figure):
    """Seconds of the parts of a run that follow each other."""
    seconds = figure["seconds"]
    named = {"read": seconds["read"], "grid": seconds["grid"],
             "fill, levels": seconds["fill"] + seconds["pyramid"]}
    named["checksums"] = max(0.0, figure["whole_s"] - sum(named.values()))
    return named


def fitted(figures, points, few, name):
    """Seconds of a phase: once, for a point by every process, and for a point divided among them.
    The four runs of one thread give them: two sizes, one and two processes."""
    def seconds(size, ranks):
        return phases_of([figure for figure in figures if figure["points"] == size
                          and figure["threads"] == 1 and figure["ranks"] == ranks][-1])[name]
    slopes = {ranks: max(0.0, seconds(points, ranks) - seconds(few, ranks)) / (points - few)
              for ranks in (1, 2)}
    everywhere = min(max(0.0, 2 * slopes[2] - slopes[1]), slopes[1])
    once = max(0.0, seconds(few, 1) - few * slopes[1])
    return once, everywhere, slopes[1] - everywhere


def model(folder):
    """A forecast from measured phases; of memory and of what is told, too."""
    figures = json.loads((folder / "figures.json").read_text())
    few, points = sorted({figure["points"] for figure in figures})[-2:]
    names = list(phases_of(figures[0]))
    fit = {name: fitted(figures, points, few, name) for name in names}
    print(f"measured: {few:.0e} and {points:.0e} points, one and two processes of one thread\n")
    print("| phase | once, s | by every process, ns a point | divided, ns a point |")
    print("|---|---:|---:|---:|")
    for name, (once, everywhere, divided) in fit.items():
        print(f"| {name} | {once:.1f} | {1e9 * everywhere:.1f} | {1e9 * divided:.1f} |")
    once = sum(part[0] for part in fit.values())
    # The many files of a site are divided for their checksums.
    everywhere = sum(part[1] for name, part in fit.items() if name != "checksums")
    divided = sum(part[2] for part in fit.values()) + fit["checksums"][1]

    def of(size, ranks):
        return [figure for figure in figures if figure["points"] == size
                and figure["ranks"] == ranks and figure["threads"] == 1][-1]
    cells = of(points, 1)["cells"] - of(few, 1)["cells"]
    per_cell = max(0.0, of(points, 2)["most_mb"] - of(few, 2)["most_mb"]) / cells
    base = of(few, 2)["most_mb"] - per_cell * of(few, 2)["cells"]
    told = (of(points, 2)["told"] - of(few, 2)["told"]) / cells  # Each process more: as much.
    print("\n| points | processes | s of work | times as fast | of it not divided, s "
          "| GB a process | GB told to each | GB to and from files | s at 0.5, 5 GB/s |")
    print("|---:|---:|---:|---:|---:|---:|---:|---:|---:|")
    for forecast in (1e9, 1e10, 1e11):
        of_cells = forecast / POINTS_A_CELL
        for ranks in (1, 16, 64, 1024):
            undivided = once + forecast * everywhere
            took = undivided + forecast * divided / ranks
            gigabytes = (base + per_cell * of_cells) / 1000
            # Points read twice, kept and read; heights and filled rows kept and read; the map.
            moved = (2 * 20 + 2 * 16) * forecast + (2 * 10 + 2 * 5 + 7) * of_cells
            print(f"| {forecast:.0e} | {ranks} | {took:.0f} "
                  f"| {(undivided + forecast * divided) / took:.1f} | {undivided:.0f} "
                  f"| {gigabytes:.1f} | {told * of_cells / 1e9:.1f} "
                  f"| {moved / 1e9:.0f} | {moved / 0.5e9:.0f}, {moved / 5e9:.0f} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("what", choices=("compare", "kill", "model"))
    numbers = lambda text: [int(part) for part in text.split(",")]  # noqa: E731
    parser.add_argument("--points", type=lambda text: int(float(text)), default=100_000_000)
    parser.add_argument("--ranks", type=numbers, default=[1, 2, 3, 4])
    parser.add_argument("--threads", type=numbers, default=[1, 2, 4])
    parser.add_argument("--kills", type=int, default=10)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    options.folder.mkdir(parents=True, exist_ok=True)
    if options.what == "compare":
        compare(options.program, options.folder, options)
    elif options.what == "kill":
        kill(options.program, options.folder, options)
    else:
        model(options.folder)


if __name__ == "__main__":
    main()
