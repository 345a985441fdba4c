#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Do two programs show the same windows? compare_windows.py OLD NEW FILE OUT_FOLDER

OLD and NEW: the programs `relievo`. Each shows the start page, FILE, the panels that are folded at first, and the dialog for figures, light,
dark, with text of 200 %, with every pixel doubled, in German and in Hindi, on a screen of its own, and the pictures are compared pixel for
pixel. One that changes from start to start of the same program is shown, too. Pictures that differ are
kept in OUT_FOLDER, with a third that has what differs in white. Needs what open_scans.py needs.
"""
import argparse
import ctypes
import os
import subprocess
import sys
import tempfile
import time

from open_scans import Screen, end_with_parent, opened, settled, write_png

LOOKS = {"light": ("theme=1", [], {}), "dark": ("theme=2", [], {}),
         "text 200 %": ("theme=1\ntext_percent=200", [], {}),
         "scale 200 %": ("theme=1", [], {"QT_SCALE_FACTOR": "2"}),
         "German": ("theme=1", ["--lang", "de"], {}), "Hindi": ("theme=1", ["--lang", "hi"], {})}
STATES = ("start", "scan", "panels", "figure")
FOLDED = ("touchAdvanced", "stereo_panel", "places_panel", "suggest_panel", "buttonsPanel", "voicePanel")
SECONDS = 120


def show(program, look, state, file):
    """(pixels, size) of one window, once it stays the same."""
    settings, words, variables = LOOKS[look]
    size = "2800x1800" if "QT_SCALE_FACTOR" in variables else "1400x900"
    if state == "panels":
        size = size.replace("x1800", "x3600").replace("x900", "x1800")
    screen = Screen(size)
    with tempfile.TemporaryDirectory() as home:
        config = os.path.join(home, "config", "relievo")
        os.makedirs(config)
        with open(os.path.join(config, "relievo.ini"), "w", encoding="utf-8") as ini:
            ini.write("[General]\n" + settings + "\n")
        if state == "panels":
            os.makedirs(os.path.join(home, "state", "relievo"))
            with open(os.path.join(home, "state", "relievo", "state.ini"), "w", encoding="utf-8") as ini:
                ini.write("[General]\nfolds=" + ", ".join("+" + name for name in FOLDED) + "\n")
        files = [] if state == "start" else [file]
        running = subprocess.Popen(
            [program] + words + files, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=end_with_parent,
            env=dict(os.environ, DISPLAY=screen.name, HOME=home, XDG_RUNTIME_DIR=home, XDG_CONFIG_HOME=os.path.join(home, "config"),
                     XDG_STATE_HOME=os.path.join(home, "state"), XDG_DATA_HOME=os.path.join(home, "data"), **variables))
        if files:
            opened(screen, file, SECONDS)
        else:
            while screen.window() is None and running.poll() is None:
                time.sleep(0.2)
        if state == "panels":
            fill(screen)
        # The panel Touch tells of the running loop, and never rests.
        picture = settled(screen, 20 if state == "panels" else SECONDS, 6)
        if state == "figure":
            screen.focus()
            screen.key("e", control=True)
            picture = settled(screen, SECONDS, 8)
        alive = running.poll() is None
        running.terminate()
        try:
            running.wait(20)
        except subprocess.TimeoutExpired:
            running.kill()
            running.wait()
    screen.close()
    if not alive:
        raise RuntimeError(f"{program} ended by itself: {look}, {state}")
    return picture, screen.size


def fill(screen):
    """Makes the program's window as large as the screen."""
    resize = screen.x.XMoveResizeWindow
    resize.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int, ctypes.c_uint, ctypes.c_uint]
    resize(screen.display, screen.window(), 0, 0, *screen.size)
    screen.x.XSync(screen.display, 0)


def differing(old, new):
    return sum(old[i:i + 3] != new[i:i + 3] for i in range(0, len(old), 3)) if old != new else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("old")
    parser.add_argument("new")
    parser.add_argument("file")
    parser.add_argument("out")
    parser.add_argument("--looks", nargs="*", default=list(LOOKS))
    parser.add_argument("--states", nargs="*", default=list(STATES))
    arguments = parser.parse_args()
    os.makedirs(arguments.out, exist_ok=True)
    changed = 0
    for look in arguments.looks:
        for state in arguments.states:
            old, size = show(arguments.old, look, state, arguments.file)
            new, _ = show(arguments.new, look, state, arguments.file)
            count = differing(old, new)
            again = differing(old, show(arguments.old, look, state, arguments.file)[0]) if count else 0
            print(f"{look}, {state}: {count} of {len(old) // 3} pixels differ" +
                  (f"; {again} between two starts of OLD" if count else ""), flush=True)
            if count > again:
                changed += 1
            if not count:
                continue
            name = os.path.join(arguments.out, f"{look}_{state}".replace(" ", "_").replace("%", ""))
            mask = b"".join(b"\xff\xff\xff" if old[i:i + 3] != new[i:i + 3] else b"\0\0\0"
                            for i in range(0, len(old), 3))
            for what, pixels in (("old", old), ("new", new), ("differs", mask)):
                write_png(f"{name}_{what}.png", pixels, size)
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main())
