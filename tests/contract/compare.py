#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Do two programs keep the same contract? Runs the same commands with both, on the same files, and lists
every difference of exit codes, reports, messages and files.

    tests/contract/compare.py [--kept] OLD NEW [FILE...]

OLD and NEW: the programs `relievo`, each with its own programs and libraries beside it. FILE: scans, maps; the samples if none is given. What tells a run from
another is left out: seconds, the commit, checksums made of it, times and compressed bytes. Exit code 1: there
are differences.

With --kept only what OLD has is asked of NEW, as a program of a later version may tell more: keys of its reports, columns of its tables,
pixels of its maps and pictures, lines of its other texts, and its files. A command that OLD does not know is left out.
"""
import itertools
import json
import re
import struct
import subprocess
import sys
import tempfile
import zlib
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
STROKE = ROOT / "data/strokes/press.csv"
# Of each file: name and words; IN and OUT stand for its names.
COMMANDS = [
    ("info", ["info", "IN"]),
    ("depthmap", ["depthmap", "IN", "-o", "OUT/map.tif", "--quality"]),
    ("depthmap cells", ["depthmap", "IN", "-o", "OUT/fewer.tif", "--cells", "150", "--holes", "none"]),
    ("depthmap front", ["depthmap", "IN", "-o", "OUT/front.tif", "--view", "front", "--cells", "90"]),
    ("depthmap rule", ["depthmap", "IN", "-o", "OUT/mean.tif", "--rule", "mean", "--cells", "120"]),
    ("depthmap tiles", ["depthmap", "IN", "-o", "OUT/tiled.tif", "--memory", "300", "--cells", "500"]),
    ("pyramid", ["pyramid", "IN", "-o", "OUT/levels.tif", "--factor", "1.7"]),
    ("touch", ["touch", "IN", "--stroke", str(STROKE), "-o", "OUT/log.csv", "--window-out", "OUT/window.tif"]),
    ("touch spline", ["touch", "IN", "--stroke", str(STROKE), "-o", "OUT/spline.csv", "--surface", "spline",
                      "--friction", "0.3", "--safety", "on"]),
    ("measure", ["measure", "IN", "--point", "3,3", "--depth", "2,2,5,4", "--profile", "1,1,6,5", "-o", "OUT/measured.csv",
                 "--profile-csv", "OUT/profile.csv", "--profile-svg", "OUT/profile.svg"]),
    ("no such option of measure", ["measure", "IN", "--point", "3,3", "--heights", "OUT/heights.csv"]),
    ("convert asc", ["convert", "IN", "OUT/map.asc"]),
    ("convert ply", ["convert", "IN", "OUT/map.ply"]),
    ("convert vti", ["convert", "IN", "OUT/map.vti"]),
    ("convert stl", ["convert", "IN", "OUT/map.stl"]),
    ("convert cog", ["convert", "IN", "OUT/cloud.tif", "--cog"]),
    ("suggest", ["suggest", "IN"]),
    ("describe", ["describe", "IN"]),
    ("render", ["render", "IN", "-o", "OUT/picture.png", "--pixels", "300"]),
    ("figure", ["figure", "IN", "-o", "OUT/figure.png"]),
    ("no such option", ["depthmap", "IN", "-o", "OUT/x.tif", "--cellls", "3"]),
    ("no such file", ["info", "OUT/nothing.ply"]),
]
OF_A_RUN = {"seconds", "commit", "wall_s", "first_view_s"}
MASKS = [(re.compile(rb'"commit":\s*"[0-9a-f]*(-changed)?"'), b'"commit":"-"'),
         (re.compile(rb"\b[0-9a-f]{64}\b"), b"<sum>"),
         (re.compile(rb"\b[0-9a-f]{40}(-changed)?\b"), b"<commit>"),
         (re.compile(rb"\([0-9a-f]{12}(-changed)?\)"), b"(<commit>)"),
         (re.compile(rb"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d+)?Z?"), b"<time>"),
         (re.compile(rb"D:\d{14}Z?"), b"<time>"),
         (re.compile(rb"\b\d+(\.\d+)? s\b"), b"<s> s")]


def masked(data):
    for pattern, text in MASKS:
        data = pattern.sub(text, data)
    return data


def without_times(value):
    if isinstance(value, dict):
        return {k: without_times(v) for k, v in value.items() if k not in OF_A_RUN}
    return [without_times(v) for v in value] if isinstance(value, list) else value


class Tiff:
    """The entries and the unpacked blocks of all directories of a little-endian TIFF."""
    SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 8, 6: 1, 7: 1, 8: 2, 9: 4, 10: 8, 11: 4, 12: 8, 16: 8, 17: 8, 18: 8}
    BLOCKS = {273: 279, 324: 325}

    def __init__(self, data):
        self.data = data
        self.big = data[2] == 43
        at = struct.unpack_from("<Q", data, 8)[0] if self.big else struct.unpack_from("<I", data, 4)[0]
        self.pages = []
        while at:
            at = self.page(at)

    def page(self, at):
        count_form, entry, place_form = ("<Q", 20, "<Q") if self.big else ("<H", 12, "<I")
        count = struct.unpack_from(count_form, self.data, at)[0]
        at += struct.calcsize(count_form)
        tags = {}
        for i in range(count):
            tag, kind = struct.unpack_from("<HH", self.data, at + i * entry)
            number = struct.unpack_from(place_form, self.data, at + i * entry + 4)[0]
            size = self.SIZES[kind] * number
            value_at = at + i * entry + (12 if self.big else 8)
            if size > struct.calcsize(place_form):
                value_at = struct.unpack_from(place_form, self.data, value_at)[0]
            tags[tag] = (kind, number, self.data[value_at:value_at + size])
        blocks = []
        for places, sizes in self.BLOCKS.items():
            if places in tags:
                blocks = self.blocks(tags[places], tags[sizes], tags[259])
        moved = set(self.BLOCKS) | set(self.BLOCKS.values()) | {330}
        kept = {t: (k, masked(v)) for t, (k, n, v) in tags.items() if t not in moved}
        self.pages.append((kept, blocks))
        return struct.unpack_from(place_form, self.data, at + count * entry)[0]

    def numbers(self, tag):
        kind, number, value = tag
        return struct.unpack("<%d%s" % (number, {3: "H", 4: "I", 16: "Q"}[kind]), value)

    def blocks(self, places, sizes, compression):
        packed = self.numbers(compression)[0] in (8, 32946)
        found = []
        for at, size in zip(self.numbers(places), self.numbers(sizes)):
            block = self.data[at:at + size]
            found.append(zlib.decompress(block) if packed and size else block)
        return found


def png_of(data):
    """Pixels, and the other chunks but those that a run writes of itself."""
    at, packed, others = 8, b"", []
    while at < len(data):
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if kind == b"IDAT":
            packed += body
        elif kind not in (b"tIME", b"iTXt", b"tEXt", b"zTXt"):
            others.append((kind, body))
        at += 12 + size
    return zlib.decompress(packed), others


def content(file):
    data = file.read_bytes()
    if data[:4] in (b"II*\0", b"II+\0"):
        return Tiff(data).pages
    if data[:4] == b"\x89PNG":
        return png_of(data)
    return masked(data)


def run(program, words, scan, folder):
    """Exit code, report, messages."""
    here = [w.replace("IN", str(scan)) if w == "IN" else w.replace("OUT", "out") for w in words]
    done = subprocess.run([str(program), *here, "--report", "json"], cwd=folder, capture_output=True,
                          timeout=1200, check=False)
    try:
        report = without_times(json.loads(masked(done.stdout)))
    except ValueError:
        report = masked(done.stdout)
    return done.returncode, report, masked(done.stderr)


def lost(old, new, place=""):
    """What of a report is gone or another: its places, and both values."""
    if isinstance(old, dict) and isinstance(new, dict):
        return [entry for key, value in old.items()
                for entry in (lost(value, new[key], f"{place}.{key}") if key in new else [f"{place}.{key} is gone"])]
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        return [entry for i, value in enumerate(old) for entry in lost(value, new[i], f"{place}[{i}]")]
    return [] if old == new else [f"{place} was {str(old)[:90]}, is {str(new)[:90]}"]


def columns(data):
    """Columns of a table of relievo by their names; None: it is none."""
    lines = [line for line in data.decode("utf-8", "replace").splitlines() if line and not line.startswith("#")]
    if not lines or "," not in lines[0]:
        return None
    names, rows = lines[0].split(","), [line.split(",") for line in lines[1:]]
    return {name: [row[i] if i < len(row) else None for row in rows] for i, name in enumerate(names)}


def values(page):
    """The bytes of a directory's values, row by row, however they are cut into blocks and made small to be packed."""
    tags, blocks = page

    def number(tag, otherwise):
        return struct.unpack_from({3: "<H", 4: "<I"}[tags[tag][0]], tags[tag][1])[0] if tag in tags else otherwise

    width, height, samples, predictor = number(256, 0), number(257, 0), number(277, 1), number(317, 1)
    size = number(258, 8) // 8
    if size == 0:  # Bits of a mask are not packed by differences.
        return width, height, b"".join(blocks)
    across, down = number(322, width), number(323, number(278, height))
    columns_of_blocks = -(-width // across)
    whole = bytearray(width * height * samples * size)
    for i, block in enumerate(blocks):
        left, top = i % columns_of_blocks * across, i // columns_of_blocks * down
        for row in range(min(down, height - top, len(block) // (across * samples * size))):
            line = unpredicted(block[row * across * samples * size:(row + 1) * across * samples * size], predictor, samples, size)
            taken = min(across, width - left) * samples * size
            at = ((top + row) * width + left) * samples * size
            whole[at:at + taken] = line[:taken]
    return width, height, bytes(whole)


def unpredicted(line, predictor, samples, size):
    if predictor == 2:  # Each value as its difference from the one before.
        most = 1 << 8 * size
        numbers = [int.from_bytes(line[at:at + size], "little") for at in range(0, len(line), size)]
        for first in range(samples):
            numbers[first::samples] = itertools.accumulate(numbers[first::samples], lambda a, b: (a + b) % most)
        return b"".join(number.to_bytes(size, "little") for number in numbers)
    if predictor == 3:  # Planes of bytes, the highest first, each as its difference from the one before.
        summed = bytearray(line)
        for first in range(samples):
            summed[first::samples] = bytes(itertools.accumulate(line[first::samples], lambda a, b: (a + b) & 255))
        plane = len(line) // size
        whole = bytearray(len(line))
        for byte in range(size):
            whole[byte::size] = summed[(size - 1 - byte) * plane:(size - byte) * plane]
        return bytes(whole)
    return line


def kept(old, new):
    """Is what a file had in the other one, too? Both as content() gives them."""
    if isinstance(old, list) and isinstance(new, list):  # TIFF
        return len(old) <= len(new) and all(values(a) == values(b) for a, b in zip(old, new))
    if isinstance(old, tuple) and isinstance(new, tuple):  # PNG
        return old[0] == new[0]
    if not isinstance(old, bytes) or not isinstance(new, bytes):
        return False
    a, b = columns(old), columns(new)
    if a is not None and b is not None:
        return all(b.get(name) == values for name, values in a.items())
    lines = set(new.splitlines())
    return all(line in lines for line in old.splitlines() if not line.startswith(b"#"))


def only_kept(results, outputs):
    """What differs of a run, of what the first program had."""
    (code, report, _), (new_code, new_report, _) = results
    wrong = [] if code == new_code else [f"exit code {code}, {new_code}"]
    if isinstance(report, bytes) and isinstance(new_report, bytes):
        wrong += [] if report == new_report else ["report"]
    else:
        wrong += lost(report, new_report, "report")
    return wrong + [name for name, old in outputs[0].items() if name not in outputs[1] or not kept(old, outputs[1][name])]


def differences(old, new, scans, commands=COMMANDS, say=print, only=False):
    """How many; each is said. Also how many commands and files were compared."""
    found = commands_run = files = 0
    for scan in scans:
        for name, words in commands:
            with tempfile.TemporaryDirectory() as bed:
                results, outputs = [], []
                for program, folder in ((old, Path(bed) / "a"), (new, Path(bed) / "b")):
                    (folder / "out").mkdir(parents=True)
                    results.append(run(program, words, scan, folder))
                    outputs.append({f.name: content(f) for f in (folder / "out").iterdir()})
                commands_run += 1
                if only:
                    unknown = results[0][0] == 1 and b"neither a verb nor a file" in results[0][2] and results[1][0] == 0
                    files += len(outputs[0])
                    wrong = [] if unknown else only_kept(results, outputs)
                    for what in wrong:
                        say(f"{scan.name}: {name}: {what}")
                    found += len(wrong)
                    continue
                wrong = [what for what, a, b in zip(("exit code", "report", "messages"), *results) if a != b]
                names = sorted(set(outputs[0]) | set(outputs[1]))
                files += len(names)
                wrong += [f for f in names if outputs[0].get(f) != outputs[1].get(f)]
                for what in wrong:
                    say(f"{scan.name}: {name}: {what} differs")
                if wrong and results[0] != results[1]:
                    say(f"  {results[0]}"[:600])
                    say(f"  {results[1]}"[:600])
                found += len(wrong)
    return found, commands_run, files


def main():
    words = [word for word in sys.argv[1:] if word != "--kept"]
    old, new = (Path(p).resolve() for p in words[:2])
    samples = sorted(p for p in (ROOT / "data/samples").iterdir() if p.suffix in (".ply", ".tif"))
    scans = [Path(p).resolve() for p in words[2:]] or samples
    found, commands, files = differences(old, new, scans, only="--kept" in sys.argv)
    print(f"{len(scans)} scans, {commands} commands with each program, {files} files: {found} differences")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
