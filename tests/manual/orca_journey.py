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
import ctypes
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
GenericMaxChunkLength 9000
GenericDelimiters ""
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
                said.append([speaker, " ".join(text.split()), Path("/proc", speaker).exists()])
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
            command = ["type", "--delay", "120", key[5:]]
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
        late = self.heard()
        if late:
            print("   later: " + " / ".join(text for text, _ in late), flush=True)
        self.position += len(late)
        for key in keys:
            self.press(key)
        said = self.quiet(expected)
        self.position += len(said)
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

    ORCA = ("orca", "-e", "speech", "-d", "braille", "-d", "key-echo")

    def __init__(self, home, log, seconds):
        self.children = Children(log)
        self.screen = Screen("1400x900")
        self.screen.x.XAutoRepeatOff.argtypes = [ctypes.c_void_p]
        self.screen.x.XAutoRepeatOff(self.screen.display)  # A busy machine would make two of a key.
        self.screen.x.XSync(self.screen.display, 0)
        os.environ["DISPLAY"] = self.screen.name
        keys = home / "openbox.xml"  # Else the window manager takes keys of the program, such as Alt+Shift+Left.
        keys.write_text('<openbox_config xmlns="http://openbox.org/3.4/rc"><keyboard/></openbox_config>')
        self.children.start(["openbox", "--config-file", str(keys)])
        self.children.start([LAUNCHER, "--launch-immediately"])
        self.voice = Voice(home, self.children)
        os.environ["SPEECHD_ADDRESS"] = "unix_socket:" + self.voice.socket
        # What is pressed is known; what is heard shall be the program's.
        self.orca = self.children.start(list(self.ORCA))
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


def walk(listener, scan, home):
    """The journey. Each step: what is done, by which keys, and what has to be heard of it."""
    step = listener.step
    name = re.escape(Path(scan).name)
    short = home / "cut_short.ply"
    whole = Path(scan).read_bytes()
    short.write_bytes(whole[:len(whole) // 2])

    def find(command, letters, runs, *result):
        step("Search for a command", ["ctrl+k"], "Search commands dialog")
        step(f"Type its words: {command}", ["type " + letters], runs)
        step(f"Run it: {command}", ["Return"], *result)

    def detail_view():
        for _ in range(2):
            if step("Go to the other view", ["ctrl+l"], "(Detail view|Overview) image"):
                if "Detail view" in listener.rows[-1][2]:
                    break

    def name_file(what, file, *result):
        step(what, ["ctrl+a", f"type {file}", "Return"], *result)

    step("The start page", [], "relievo", "Open push button")
    step("Ask for a file", ["ctrl+o"], "Open dialog", "File name")
    name_file("Name the scan", scan, name, "Detail view", "is open")
    step("Where am I?", ["ctrl+i"], "In the air")
    step("Move the hand, and ask", ["3 Right", "2 shift+Up", "ctrl+i"], "In the air|Touching", "middle|top")
    step("Forces on", ["F5"], "Forces on")
    step("Push in, and ask", ["5 Page_Down", "ctrl+i"], "Touching")
    step("Ask at length", ["ctrl+alt+i"], "edge", "Resolution 1 of", "hand")
    for part in ("Scan panel", "Plots of height and force", "Message"):
        step("Next part of the window", ["F6"], part)
    step("The force, four fields on", ["4 Tab"], r"Force: [\d.]+.* N")
    detail_view()
    step("Forces off", ["Escape"], "Forces off")
    step("Feel with the mouse", ["ctrl+m"], "mouse feels")
    step("End that", ["Escape"], "no longer feels")
    step("Go to the overview", ["ctrl+l"], "Overview image", "window")
    step("Begin to draw a window", ["space"], "Drawing a window")
    step("Carry its corner", ["10 Right", "6 Up"], "mm|millimetres|centimetres")
    step("Take it", ["Return"], "Resolution|Window")
    step("Ask for resolution and scale", ["ctrl+shift+i"], "Resolution", "wide")
    step("Type the window in numbers", ["ctrl+g"], "spin button")
    step("The next number", ["Tab"], "spin button")
    detail_view()
    step("The whole object", ["ctrl+0"], "Resolution 1|[Ww]hole")
    step("Finer", ["ctrl+plus"], "Resolution 2 of")
    step("Coarser", ["ctrl+minus"], "Resolution 1 of")
    for _ in range(3):
        step("Undo", ["ctrl+z"], "Undone: ")
    for _ in range(3):
        step("Redo", ["ctrl+y"], "Done again: ")
    find("Hillshade, four lights", "hillshade four", "four lights", "four lights")
    step("Turn the light", ["alt+shift+Left"], r"Light from \d+ degrees")
    step("Lift the light", ["alt+shift+Up"], r"\d+ degrees high")
    find("Profile", "heights along", "Profile", "place 1 of 2")
    step("Its first place", ["4 shift+Left", "Return"], "place 2 of 2")
    step("Its second place", ["8 shift+Right", "Return"], "place 3|F ends")
    step("End the profile", ["f"], "length [\\d.]+ .*millimetres", "height range [\\d.]+")
    find("Save profile as shown", "save profile", "Save profile", "File name")
    name_file("Name the numbers", home / "profile.csv", "profile.csv is saved")
    detail_view()
    step("Forces on", ["F5"], "Forces on")
    step("Record", ["ctrl+r"], "Recording to")
    step("Push, draw a stroke, end the recording", ["4 Page_Down", "6 Right", "ctrl+r"], "Recording saved", "samples")
    step("Forces off", ["Escape"], "Forces off")
    step("Ask for a replay", ["ctrl+shift+r"], "Replay dialog", "File name")
    recordings = sorted(home.rglob("*_001.csv")) or [home / "no_recording.csv"]
    name_file("Name the recording", recordings[0], "Replay of", "Space plays")
    step("Play it", ["ctrl+space"], "Playing|Paused")
    step("Its place and speed, three fields on", ["3 Tab"], "Speed: 1")
    step("Slower", ["2 Down"], "0.25")
    step("Close the replay", ["Escape"], "Replay closed")
    step("Ask for a figure", ["ctrl+e"], "Figure dialog", "File")
    name_file("Name it, and Enter", home / "figure.png", "figure.png is saved")
    if not step("Is the dialog gone? Where am I?", ["ctrl+i"], "Touching|In the air"):
        step("Leave the dialog", ["Escape"], "relievo frame")
    step("Preferences", ["ctrl+comma"], "Preferences")
    step("Search them for the text size", ["type text size"], "Settings found: 1")
    step("Go to what was found", ["Tab"], "Text size|Appearance")
    step("Go on", ["Tab"], "Text size")
    step("Close them", ["Escape"], "relievo frame")
    step("Save the project", ["ctrl+s"], "Save|File name")
    name_file("Name it", home / "work.relievo.json", "work.relievo.json is saved")
    step("Ask for the wrong file", ["ctrl+o"], "Open dialog", "File name")
    name_file("Name the file that is cut short", short, "Cannot read cut_short.ply", "Nothing was loaded",
              "Ctrl\\+Return")
    step("Is the scan still there?", ["ctrl+i"], "Touching|In the air")
    detail_view()
    step("Go back to the message", ["3 shift+F6"], "Cannot read cut_short.ply", "Load what is there push button")
    step("Its next button", ["Tab"], "push button")
    step("Drop a marker, so that something is unsaved", ["ctrl+b"], "set|removed")
    step("All keys", ["F1"], "Keys")
    step("Close them", ["Escape"], "relievo frame")
    step("Quit with unsaved work", ["ctrl+q"], "Save|Discard")
    step("Stay", ["Escape"], "relievo frame")


def versions(relievo):
    """What was tried with what."""
    for command in (["orca", "--version"], ["speech-dispatcher", "--version"], [relievo, "--version"]):
        said = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL).stdout
        yield Path(command[0]).name + ": " + (said.strip().splitlines() or ["no version"])[0]


def write_table(file, rows):
    def cell(text):
        return re.sub(r"(/\S+)+/(?=\S)", "", text).replace("|", "\\|")

    with open(file, "w", encoding="utf-8") as out:
        out.write("| # | Step | Keys | What Orca said | Verdict |\n|---|---|---|---|---|\n")
        for number, (what, keys, words, verdict) in enumerate(rows, 1):
            out.write(f"| {number} | {what} | {cell(', '.join(keys))} | {cell(words)} | {cell(verdict)} |\n")


def on_own_desk(arguments):
    """In a bus of its own and a home of its own: the whole journey."""
    home = Path(os.environ["HOME"])
    with open(arguments.log or os.devnull, "w", encoding="utf-8") as log:
        desk = Desk(home, log, arguments.seconds)
        try:
            desk.children.start([arguments.relievo])
            walk(desk.listener, arguments.scan, home)
        finally:
            desk.end()
    rows = desk.listener.rows
    if arguments.table:
        write_table(arguments.table, rows)
    bad = [row for row in rows if row[3] != "said"]
    print(f"{len(rows)} steps, {len(rows) - len(bad)} said, {len(bad)} not")
    return 1 if bad else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("relievo")
    parser.add_argument("scan")
    parser.add_argument("--table", help="write the steps as a table in Markdown")
    parser.add_argument("--log", help="write what the started programs print")
    parser.add_argument("--seconds", type=float, default=25, help="the longest wait for what a step has to say")
    arguments = parser.parse_args()
    arguments.relievo, arguments.scan = str(Path(arguments.relievo).resolve()), str(Path(arguments.scan).resolve())
    if "RELIEVO_ON_OWN_BUS" in os.environ:
        return on_own_desk(arguments)
    lacking = [program for program in PROGRAMS if not shutil.which(program)]
    if lacking or not Path(LAUNCHER).exists():
        print("Skipped, not installed: " + ", ".join(lacking or ["at-spi2-core"]))
        return SKIPPED
    if subprocess.run(["pgrep", "-u", str(os.getuid()), "-x", "orca"], stdout=subprocess.DEVNULL).returncode == 0:
        print("Skipped: another Orca of this user runs.")  # It would not let a second one be.
        return SKIPPED
    for line in versions(arguments.relievo):
        print(line, flush=True)
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as folder:
        environment = dict(os.environ, RELIEVO_ON_OWN_BUS="1", HOME=folder, LANG="C.UTF-8", GSETTINGS_BACKEND="memory",
                           QT_ACCESSIBILITY="1", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1")
        for variable in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"):
            environment[variable] = str(Path(folder) / variable)
            Path(environment[variable]).mkdir(mode=0o700)
        environment.pop("DBUS_SESSION_BUS_ADDRESS", None)
        environment.pop("AT_SPI_BUS_ADDRESS", None)
        return subprocess.run(["dbus-run-session", "--", sys.executable, *sys.argv], env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())
