#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What a screen reader meets: the window, every panel and every dialog, over AT-SPI on a bus of its own.

    screen_reader_test.py RELIEVO SCAN [LANGUAGE...]

Fails at whatever has the keyboard or can be pressed and has no name, at what has no role, at a list whose choice
is not said, at a section that does not say whether it is open, and at a command whose answer is not announced.
Needs a screen. Without at-spi2-core or its bindings for Python it says so and is skipped (77).
"""
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LAUNCHER = "/usr/libexec/at-spi-bus-launcher"
SKIPPED = 77
PATIENCE_S = 120
ESCAPE = 0xFF1B

try:
    import gi

    gi.require_version("Atspi", "2.0")
    from gi.repository import Atspi, GLib
except (ImportError, ValueError) as missing:
    print(f"Skipped: {missing}")
    sys.exit(SKIPPED)

State = Atspi.StateType
Role = Atspi.Role
PRESSED = {Role.PUSH_BUTTON, Role.CHECK_BOX, Role.RADIO_BUTTON, Role.TOGGLE_BUTTON, Role.MENU_ITEM, Role.PAGE_TAB}


def holds(question, patience_s=PATIENCE_S):
    """Waits until `question()` is true. Returns its answer, the last one if it never was."""
    end = time.monotonic() + patience_s
    while True:
        turn()
        try:
            answer = question()
        except GLib.Error:
            answer = None
        if answer or time.monotonic() > end:
            return answer
        time.sleep(0.1)


def turn():
    """Lets what has arrived on the bus reach its listeners."""
    while GLib.MainContext.default().iteration(False):
        pass


def children(thing):
    for index in range(thing.get_child_count()):
        child = thing.get_child_at_index(index)
        if child is not None:
            yield child


def below(thing, path=()):
    """All objects below this one, with the names of those above them."""
    for child in children(thing):
        here = path + (f"{child.get_role_name()} '{child.get_name()}'",)
        yield here, child
        yield from below(child, here)


class Program:
    """The program with its window, as a screen reader finds it."""

    def __init__(self, relievo, scan, language):
        environment = dict(os.environ, QT_ACCESSIBILITY="1", QT_LINUX_ACCESSIBILITY_ALWAYS_ON="1")
        self.process = subprocess.Popen([relievo, "--lang", language, scan], env=environment)
        self.tree = holds(self.find)
        assert self.tree, "The program did not come to the bus."
        name = Path(scan).name
        assert holds(lambda: any(name in w.get_name() for w in self.windows())), "The scan was not opened."

    def find(self):
        for each in children(Atspi.get_desktop(0)):
            if each.get_process_id() == self.process.pid:
                return each
        return None

    def windows(self):
        """Those that are shown."""
        self.tree.clear_cache()
        return [w for w in children(self.tree) if w.get_state_set().contains(State.SHOWING)]

    def end(self):
        self.process.send_signal(signal.SIGTERM)
        try:
            self.process.wait(60)
        except subprocess.TimeoutExpired:
            self.process.kill()


def is_qts_own(dialog):
    """Its dialog for files, of which Qt names little; desktops bring theirs."""
    return any(thing.get_role() == Role.LIST and thing.get_name() in ("Sidebar", "Seitenleiste") for _, thing in below(dialog))


def complaints_of(thing):
    """What is wrong with this one."""
    states = thing.get_state_set()
    role = thing.get_role()
    name = thing.get_name()
    if role == Role.TABLE_CELL:
        return  # An empty one has nothing to say.
    if states.contains(State.FOCUSABLE) and not name:
        yield "has the keyboard and no name"
    elif role in PRESSED and not name:
        yield "can be pressed and has no name"
    if role in (Role.UNKNOWN, Role.INVALID):
        yield "has no role"
    if role == Role.COMBO_BOX and not states.contains(State.EDITABLE) and states.contains(State.SHOWING) and ": " not in name:
        yield f"does not say its choice: '{name}'"


def complaints(window):
    found = []
    seen = 0
    for path, thing in below(window):
        seen += 1
        try:
            found += [f"{' > '.join(path)} {words}" for words in complaints_of(thing)]
        except GLib.Error:  # Gone meanwhile, as labels go that change.
            continue
    return seen, found


def commands(window, ending):
    """Commands of the menus whose words end so, with those words."""
    for path, thing in below(window):
        if thing.get_role() == Role.MENU_ITEM and thing.get_name().endswith(ending):
            yield thing.get_name(), thing


def press(thing):
    """By the first thing that can be done with it. A dialog that waits answers late."""
    try:
        thing.do_action(0)
    except GLib.Error:
        pass


def key(symbol):
    Atspi.generate_keyboard_event(symbol, None, Atspi.KeySynthType.SYM)


def walk_dialogs(program, wrong):
    """Opens each dialog of the menus, looks at all of it, and closes it."""
    main = program.windows()[0]
    opened = 0
    for words, command in list(commands(main, "…")):
        if not command.get_state_set().contains(State.ENABLED):
            continue
        before = len(program.windows())
        press(command)
        if not holds(lambda: len(program.windows()) > before, 10):
            continue  # It asks in the strip, say.
        for dialog in program.windows()[before:]:
            opened += 1
            if is_qts_own(dialog):
                continue
            seen, found = complaints(dialog)
            wrong += [f"{words}: {each}" for each in found]
            print(f"  {words}: {seen} objects, {len(found)} complaints", flush=True)
        for _ in range(20):
            if len(program.windows()) <= before:
                break
            key(ESCAPE)
            holds(lambda: len(program.windows()) <= before, 2)
        # Nobody manages the windows of this screen: what does not wait may be without the keyboard.
        still = program.windows()[before:]
        if any(w.get_state_set().contains(State.ACTIVE) for w in still):
            left = ", ".join(f"{w.get_role_name()} '{w.get_name()}'" for w in still)
            wrong.append(f"{words}: Escape does not close {left}")
        if still:
            return opened
    return opened


class Announcements:
    """What is announced, as a screen reader is told of it."""

    def __init__(self, program):
        self.heard = []
        self.process = program.process.pid
        self.listener = Atspi.EventListener.new(self.take)
        self.listener.register("object:state-changed:showing")

    def take(self, event):
        if event.source.get_process_id() == self.process and event.source.get_role() == Role.NOTIFICATION:
            self.heard.append(event.source.get_name())

    def after(self, action):
        """The first announcement that comes after it; empty: none came."""
        del self.heard[:]
        action()
        holds(lambda: self.heard, 20)
        return self.heard[0] if self.heard else ""

    def end(self):
        self.listener.deregister("object:state-changed:showing")


def by_name(window, role, start):
    for _, thing in below(window):
        if thing.get_role() == role and thing.get_name().startswith(start):
            return thing
    return None


def walk_english(program):
    """What depends on words, in one language."""
    window = program.windows()[0]
    wrong = []

    def expect(truth, words):
        if not truth:
            wrong.append(words)

    sections = [t for _, t in below(window) if t.get_state_set().contains(State.EXPANDABLE) and t.get_name().endswith(" panel")]
    expect(len(sections) >= 10, f"{len(sections)} sections say whether they are open")
    folded = next((s for s in sections if not s.get_state_set().contains(State.EXPANDED)), None)
    if folded is None:
        return wrong + ["no section says that it is folded: " + ", ".join(s.get_name() for s in sections)]
    press(folded)
    expect(holds(lambda: folded.get_state_set().contains(State.EXPANDED), 10), f"{folded.get_name()} does not say that it is open")
    size = by_name(window, Role.LABEL, "Size: ")
    expect(size is not None and "mm" in size.get_name(), "the size is not said with its numbers")
    view = next((t for _, t in below(window) if t.get_name() == "Detail view"), None)
    expect(view is not None and "mm" in view.get_description(), "the view does not say where the hand is")
    announcements = Announcements(program)
    for command, part in (("Where am I", "middle"), ("Finer", "esolution"), ("Where am I", "middle")):
        thing = next((t for n, t in commands(window, "") if n == command), None)
        if thing is None:
            wrong.append(f"there is no command '{command}'")
            continue
        said = announcements.after(lambda: press(thing))
        expect(part in said, f"after '{command}' this is announced: '{said}'")
    announcements.end()
    return wrong


def main(relievo, scan, languages):
    wrong = []
    Atspi.set_timeout(3000, 30000)
    for language in languages:
        program = Program(relievo, scan, language)
        try:
            seen, found = complaints(program.windows()[0])
            print(f"{language}: {seen} objects in the window, {len(found)} complaints", flush=True)
            wrong += [f"{language}: {each}" for each in found]
            if language == "en":
                wrong += walk_english(program)
            of_dialogs = []
            opened = walk_dialogs(program, of_dialogs)
            print(f"{language}: {opened} dialogs", flush=True)
            wrong += [f"{language}: {each}" for each in of_dialogs]
        finally:
            program.end()
    for each in wrong:
        print(each)
    return 1 if wrong else 0


def on_own_bus():
    """Starts this again on a session bus of its own, with the service that screen readers use."""
    if not shutil.which("dbus-run-session") or not Path(LAUNCHER).exists():
        print("Skipped: dbus-run-session or at-spi2-core is not installed.")
        return SKIPPED
    with tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, RELIEVO_ON_OWN_BUS="1", HOME=folder)
        for variable in ("XDG_RUNTIME_DIR", "XDG_CONFIG_HOME", "XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME"):
            environment[variable] = str(Path(folder) / variable)
            Path(environment[variable]).mkdir(mode=0o700)
        environment.pop("DBUS_SESSION_BUS_ADDRESS", None)
        environment.pop("AT_SPI_BUS_ADDRESS", None)
        return subprocess.run(["dbus-run-session", "--", sys.executable, *sys.argv], env=environment).returncode


if __name__ == "__main__":
    if "RELIEVO_ON_OWN_BUS" not in os.environ:
        sys.exit(on_own_bus())
    launcher = subprocess.Popen([LAUNCHER, "--launch-immediately"])
    try:
        sys.exit(main(sys.argv[1], sys.argv[2], sys.argv[3:] or ["en", "de", "hi"]))
    finally:
        launcher.terminate()
