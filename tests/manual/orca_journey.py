#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the journey of a researcher by keys alone with the screen reader Orca, and says what Orca said.

orca_journey.py RELIEVO SCAN  starts a screen, a bus, a window manager, a speech dispatcher, Orca and the program,
all of them its own, presses keys, and waits after each for what Orca says. It prints every step with its keys, what
was heard, and a verdict. What Orca itself cut off in the middle stands in brackets and does not count as said. The
script ends with 1 if a step said nothing or not what was expected, and with 77 if something that it needs is missing.

SCAN is a PLY that says its unit; a copy that is cut short is the wrong file of the journey. --table FILE also writes
the steps as a table in Markdown, --seconds 60 is the longest wait for what a step has to say.

It needs Orca, speech-dispatcher with its generic module, at-spi2-core, dbus-run-session, Xvfb, xdotool, libX11 and
libXtst, and openbox as window manager, because without one no window is told that it has the keys. No other Orca of
the same user may run meanwhile, because Orca refuses to be the second one. The voice writes into a file instead of
speaking; it takes 20 ms for each letter, as somebody hears who is used to it, so that a cut is a cut.
"""
import argparse
import os
import re
import shutil
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from open_scans import Screen, end_with_parent

LAUNCHER = "/usr/libexec/at-spi-bus-launcher"
PROGRAMS = ("orca", "speech-dispatcher", "dbus-run-session", "Xvfb", "xdotool", "openbox")
SKIPPED = 77
QUIET_S = 2.5  # So long nothing more is said.

SPEECHD_CONF = """LogLevel 3
AudioOutputMethod "libao"
AddModule "text" "sd_generic" "text.conf"
DefaultModule text
"""
MODULE_CONF = """Debug 0
GenericExecuteSynth "sh {folder}/say.sh '$DATA'"
GenericLanguage "en" "en" "utf-8"
GenericPunctNone ""
AddVoice "en" "male1" "en"
"""
# A record ends with the control character 036; one that was cut off has no second record.
SAY = """printf '%s|%s\\036' $$ "$1" >>{folder}/said
ms=$(( ${{#1}} * 20 ))
sleep $(( ms / 1000 )).$(printf %03d $(( ms % 1000 )))
printf '%s|\\036' $$ >>{folder}/said
"""


class Voice:
    """A speech dispatcher of its own, whose only voice writes into a file what it says."""

    def __init__(self, home, children):
        self.folder = home / "voice"
        (self.folder / "modules").mkdir(parents=True)
        (self.folder / "speechd.conf").write_text(SPEECHD_CONF)
        (self.folder / "modules" / "text.conf").write_text(MODULE_CONF.format(folder=self.folder))
        (self.folder / "say.sh").write_text(SAY.format(folder=self.folder))
        (home / ".libao").write_text("default_driver=null\n")
        self.socket = str(self.folder / "socket")
        folder = str(self.folder)
        children.start(["speech-dispatcher", "-s", "-t", "0", "-C", folder, "-S", self.socket, "-P", folder + "/pid",
                        "-L", folder])
        wait_for(self.listens, 60, "the speech dispatcher")

    def listens(self):
        try:
            with socket.socket(socket.AF_UNIX) as connection:
                connection.connect(self.socket)
            return True
        except OSError:
            return False

    def said(self):
        """All so far, as pairs: text, and whether it was said to its end. Of the one being said: None."""
        file = self.folder / "said"
        records = file.read_text(errors="replace").split("\036")[:-1] if file.exists() else []
        said = []
        for record in records:
            speaker, text = record.split("|", 1)
            if text:
                said.append([speaker, text, Path("/proc", speaker).exists()])
            else:
                for one in reversed(said):
                    if one[0] == speaker:
                        one[2] = True
                        one[0] = ""
                        break
        return [(text, None if speaker and alive else not speaker) for speaker, text, alive in said]


class Children:
    """What was started and has to end."""

    def __init__(self, log):
        self.log = log
        self.processes = []

    def start(self, command, **more):
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=self.log, stderr=self.log,
                                   preexec_fn=end_with_parent, **more)
        self.processes.append(process)
        return process

    def end(self):
        for process in reversed(self.processes):
            process.terminate()
            try:
                process.wait(20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def wait_for(question, seconds, what):
    end = time.monotonic() + seconds
    while not question():
        if time.monotonic() > end:
            raise RuntimeError(f"After {seconds} s there is no sign of {what}.")
        time.sleep(0.2)


class Listener:
    """Presses keys and hears what comes of it."""

    def __init__(self, voice, display, seconds):
        self.voice = voice
        self.environment = dict(os.environ, DISPLAY=display)
        self.seconds = seconds
        self.rows = []
        self.position = 0

    def press(self, key):
        """One key, "7 Right" for one that is pressed several times, or "type ..." for letters."""
        if key.startswith("type "):
            command = ["type", "--delay", "80", key[5:]]
        else:
            times, name = key.split() if " " in key else ("1", key)
            command = ["key", "--delay", "80", "--repeat", times, "--repeat-delay", "80", name]
        subprocess.run(["xdotool", *command], env=self.environment, check=True)

    def heard(self):
        return self.voice.said()[self.position:]

    def quiet(self, expected=()):
        """Waits until all that is expected was said and nothing more comes; at the limit it waits no longer."""
        end = time.monotonic() + self.seconds
        last, since = None, time.monotonic()
        while time.monotonic() < end:
            now = self.heard()
            if now != last or any(whole is None for _, whole in now):
                last, since = now, time.monotonic()
            elif time.monotonic() - since > QUIET_S and not missing(now, expected):
                break
            time.sleep(0.1)
        return self.heard()

    def step(self, what, keys, *expected):
        """Presses the keys one after the other and expects each of these regular expressions to be said."""
        self.position = len(self.voice.said())
        for key in keys:
            self.press(key)
        said = self.quiet(expected)
        lacking = missing(said, expected)
        verdict = "said" if said and not lacking else "silent" if not said else "not said: " + ", ".join(lacking)
        words = " / ".join(text if whole else f"[{text}]" for text, whole in said)
        self.rows.append((what, keys, words, verdict))
        print(f"{len(self.rows)}. {what}\n   keys:  {', '.join(keys) or 'none'}\n   heard: {words}\n   {verdict}",
              flush=True)
        return not lacking


def missing(said, expected):
    text = " / ".join(words for words, whole in said if whole)
    return [one for one in expected if not re.search(one, text, re.IGNORECASE)]


class Desk:
    """A screen with a window manager, an own home, a bus for screen readers, a voice and Orca."""

    def __init__(self, home, log, seconds):
        self.children = Children(log)
        self.screen = Screen("1400x900")
        os.environ["DISPLAY"] = self.screen.name
        self.children.start(["openbox"])
        self.children.start([LAUNCHER, "--launch-immediately"])
        self.voice = Voice(home, self.children)
        os.environ["SPEECHD_ADDRESS"] = "unix_socket:" + self.voice.socket
        # What is pressed is known; what is heard shall be the program's.
        self.orca = self.children.start(["orca", "-e", "speech", "-d", "braille", "-d", "key-echo"])
        wait_for(self.orca_speaks, 120, "Orca")
        self.listener = Listener(self.voice, self.screen.name, seconds)
        self.listener.quiet()

    def orca_speaks(self):
        if self.orca.poll() is not None:
            raise RuntimeError("Orca has ended; another one of the same user may run.")
        return any("screen reader on" in text.lower() for text, _ in self.voice.said())

    def end(self):
        self.children.end()
        self.screen.close()
