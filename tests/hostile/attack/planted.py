# SPDX-License-Identifier: BSD-3-Clause
"""Holds the attack to its word: programs with one fault each, all of which it has to find.

planted.py RELIEVO GOOD_FILES  Each of them is relievo behind a script that spoils one thing.
"""
import os
import subprocess
import sys
import tempfile

# What is done after (or instead of) the real run whose answer is in $code; and who has to see it.
FAULTS = {
    "dies of a signal": ("case $1 in info) kill -SEGV $$;; esac", ["--files", "30"]),
    "lets a library speak": ("[ $code = 2 ] && echo 'terminate called after' >&2", ["--files", "30"]),
    "fails without a word": ("case $1 in info) : > \"$answer\"; : > \"$words\"; code=2;; esac",
                             ["--files", "30"]),
    "writes no JSON": ("[ $code = 0 ] && echo '{\"seconds\": nan}'", ["--files", "30"]),
    "leaves what it failed to make": ("[ $code = 2 ] && : > out.tif", ["--files", "40"]),
    "leaves a temporary file": ("[ $1 = convert ] && : > .left.tmp", ["--kills", "12", "--only", "convert .asc"]),
    # The first two are what the others are held against.
    "writes half from the third time on": (
        "[ $1 = convert ] && echo >> \"$0.times\" && [ $(wc -l < \"$0.times\") -gt 2 ] && "
        "head -c 900 \"$3\" > h && mv h \"$3\"",
        ["--kills", "12", "--only", "convert .asc"]),
    "loses the earlier output": ("[ $code != 0 ] && rm -f \"$3\"",
                                 ["--disks", "3", "--only", "convert .asc"]),
    "overwrites what it reads": ("[ $1 = convert ] && echo >> scan.ply",
                                 ["--kills", "12", "--only", "convert .asc"]),
    "notices no change": ("case \"$*\" in *--verify*|*verify*) echo '{}' > \"$answer\"; code=0;; esac",
                          ["--changes", "12"]),
    "takes files of two sets for one": ("[ $1 = info ] && code=0 && : > \"$words\"",
                                        ["--mixed", "--only", "figure pdf"]),
    "takes any number": ("[ $1 = measure ] && [ $code = 1 ] && echo '{}' && code=0",
                         ["--options", "--only", "measure"]),
}
SCRIPT = """#!/bin/bash
answer=$(mktemp)
words=$(mktemp)
trap 'rm -f "$answer" "$words"' EXIT
{program} "$@" > "$answer" 2> "$words"
code=$?
{fault}
cat "$words" >&2
cat "$answer"
exit $code
"""


def finds(relievo, good_files, fault, attack, folder):
    script = os.path.join(folder, "relievo")
    with open(script, "w", encoding="utf-8") as stream:
        stream.write(SCRIPT.format(program=relievo, fault=fault))
    os.chmod(script, 0o755)
    run = subprocess.run([sys.executable, os.path.dirname(__file__), script, good_files, *attack],
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    # An attack that broke down has found nothing; no right to mount disks is no answer.
    found = run.returncode == 1 and b"| Attack |" in run.stdout
    return found or b"are skipped" in run.stdout, run.stdout.decode()


def main():
    relievo, good_files = (os.path.abspath(word) for word in sys.argv[1:3])
    missed = 0
    for name, (fault, attack) in FAULTS.items():
        with tempfile.TemporaryDirectory() as folder:
            found, said = finds(relievo, good_files, fault, attack, folder)
        print(("found:  " if found else "MISSED: ") + "a program that " + name, flush=True)
        if not found:
            missed += 1
            print(said)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main())
