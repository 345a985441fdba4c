#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Opens scans in the window, one after the other, each on a screen of its own, and keeps pictures.

open_scans.py RELIEVO OUT_FOLDER FILE...  Every picture has to be looked at; contact_sheet puts them
side by side. --look "natural" searches for a command once the scan is open and takes it, --size
1400x900 is the screen's, --crop 371,141,733,537 keeps a part of it, such as the right view, --seconds
60 is the longest wait for the file, and for a picture that no longer changes.
Needs Xvfb, libX11 and libXtst, and no Python package.
"""
import argparse
import ctypes
import ctypes.util
import os
import signal
import struct
import subprocess
import sys
import tempfile
import time
import zlib

Z_PIXMAP = 2
PR_SET_PDEATHSIG = 1
LIBC = ctypes.CDLL(None)
PARENT = os.getpid()


def end_with_parent():
    """In a child before it starts: it is told to end when this script does, however that ends."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGTERM)
    if os.getppid() != PARENT:  # It ended before it was asked.
        os._exit(1)


class XImage(ctypes.Structure):
    _fields_ = [(name, ctypes.c_int) for name in ("width", "height", "xoffset", "format")] + [
        ("data", ctypes.POINTER(ctypes.c_ubyte))] + [
        (name, ctypes.c_int) for name in ("byte_order", "unit", "bit_order", "pad", "depth",
                                          "bytes_per_line", "bits_per_pixel")]


class Screen:
    """A screen without a monitor."""

    def __init__(self, size):
        read, write = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(write), "-screen", "0", size + "x24", "-nolisten", "tcp",
             "-noreset"], pass_fds=(write,), stderr=subprocess.DEVNULL, preexec_fn=end_with_parent)
        os.close(write)
        with os.fdopen(read) as answer:  # The server writes number and line end one by one.
            self.name = ":" + answer.readline().strip()
        self.x = ctypes.CDLL(ctypes.util.find_library("X11"))
        self.test = ctypes.CDLL(ctypes.util.find_library("Xtst"))
        self.x.XOpenDisplay.restype = ctypes.c_void_p
        self.x.XDefaultRootWindow.argtypes = [ctypes.c_void_p]
        self.x.XDefaultRootWindow.restype = ctypes.c_ulong
        self.x.XGetImage.restype = ctypes.POINTER(XImage)
        self.x.XGetImage.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int, ctypes.c_int,
                                     ctypes.c_uint, ctypes.c_uint, ctypes.c_ulong, ctypes.c_int]
        self.x.XStringToKeysym.restype = ctypes.c_ulong
        self.x.XKeysymToKeycode.argtypes = [ctypes.c_void_p, ctypes.c_ulong]
        self.test.XTestFakeKeyEvent.argtypes = [ctypes.c_void_p, ctypes.c_uint, ctypes.c_int,
                                                ctypes.c_ulong]
        self.x.XSync.argtypes = [ctypes.c_void_p, ctypes.c_int]
        self.x.XDestroyImage.argtypes = [ctypes.POINTER(XImage)]
        # A window may go while it is asked about; Xlib's own answer ends the script.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(
            lambda display, error: 0)
        self.x.XSetErrorHandler(self.ignore)
        self.display = None
        while self.display is None and self.server.poll() is None:
            self.display = self.x.XOpenDisplay(self.name.encode())
        if self.display is None:
            raise RuntimeError("Xvfb ended with status " + str(self.server.poll()))
        self.size = [int(n) for n in size.split("x")]

    def close(self):
        self.server.terminate()
        self.server.wait()

    def picture(self):
        """Rows of red, green, blue."""
        width, height = self.size
        image = self.x.XGetImage(self.display, self.x.XDefaultRootWindow(self.display), 0, 0,
                                 width, height, 0xFFFFFFFF, Z_PIXMAP)
        if not image:
            raise RuntimeError("the screen gives no picture")
        raw = ctypes.string_at(image.contents.data, image.contents.bytes_per_line * height)
        self.x.XDestroyImage(image)
        rgb = bytearray(3 * width * height)
        for channel in range(3):
            rgb[channel::3] = raw[2 - channel::4]
        return bytes(rgb)

    def key(self, name, control=False):
        control_code = self.x.XKeysymToKeycode(self.display, self.x.XStringToKeysym(b"Control_L"))
        code = self.x.XKeysymToKeycode(self.display, self.x.XStringToKeysym(name.encode()))
        if control:
            self.test.XTestFakeKeyEvent(self.display, control_code, 1, 0)
        for down in (1, 0):
            self.test.XTestFakeKeyEvent(self.display, code, down, 0)
        if control:
            self.test.XTestFakeKeyEvent(self.display, control_code, 0, 0)
        self.x.XSync(self.display, 0)
        time.sleep(0.05)

    def window(self, topmost=False):
        """The largest one, or the one on top of all; None if there is none."""
        root, parent, children, count = (ctypes.c_ulong(), ctypes.c_ulong(),
                                         ctypes.POINTER(ctypes.c_ulong)(), ctypes.c_uint())
        self.x.XQueryTree.argtypes = [ctypes.c_void_p, ctypes.c_ulong] + [ctypes.c_void_p] * 4
        self.x.XQueryTree(self.display, self.x.XDefaultRootWindow(self.display),
                          ctypes.byref(root), ctypes.byref(parent), ctypes.byref(children),
                          ctypes.byref(count))
        self.x.XGetGeometry.argtypes = [ctypes.c_void_p, ctypes.c_ulong] + [ctypes.c_void_p] * 7
        best, most = None, 0
        for i in range(count.value):
            width, height, rest = ctypes.c_uint(), ctypes.c_uint(), (ctypes.c_ulong * 5)()
            places = [ctypes.addressof(rest) + 8 * k for k in range(5)]
            self.x.XGetGeometry(self.display, children[i], places[0], places[1], places[2],
                                ctypes.byref(width), ctypes.byref(height), places[3], places[4])
            if topmost and width.value > 100 or width.value * height.value > most:
                best, most = children[i], width.value * height.value
        return best

    def focus(self, topmost=False):
        """Without a window manager nobody gives the program's windows the keys."""
        self.x.XSetInputFocus.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.c_int,
                                          ctypes.c_ulong]
        window = self.window(topmost)
        if window is not None:
            self.x.XSetInputFocus(self.display, window, 1, 0)
        self.x.XSync(self.display, 0)

    def title(self):
        """Of the largest window, whatever its encoding, as bytes."""
        class Property(ctypes.Structure):
            _fields_ = [("value", ctypes.c_char_p), ("encoding", ctypes.c_ulong),
                        ("format", ctypes.c_int), ("items", ctypes.c_ulong)]
        self.x.XGetWMName.argtypes = [ctypes.c_void_p, ctypes.c_ulong, ctypes.POINTER(Property)]
        window, name = self.window(), Property()
        if window is None or not self.x.XGetWMName(self.display, window, ctypes.byref(name)):
            return b""
        return name.value or b""


def write_png(file, rgb, size):
    width, height = size
    rows = b"".join(b"\0" + rgb[3 * width * y:3 * width * (y + 1)] for y in range(height))

    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))

    with open(file, "wb") as out:
        out.write(b"\x89PNG\r\n\x1a\n")
        out.write(chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)))
        out.write(chunk(b"IDAT", zlib.compress(rows, 6)) + chunk(b"IEND", b""))


def cropped(rgb, size, part):
    """The part's pixels and size."""
    x, y, width, height = [int(n) for n in part.split(",")] if part else (0, 0, *size)
    lines = [rgb[3 * (size[0] * row + x):3 * (size[0] * row + x + width)]
             for row in range(y, y + height)]
    return b"".join(lines), (width, height)


def opened(screen, file, seconds):
    """Waits until the window is called after the file; a refused one never is."""
    end = time.time() + seconds
    while time.time() < end and os.fsencode(os.path.basename(file)) not in screen.title():
        time.sleep(0.2)


def settled(screen, seconds, least):
    """The picture once it has stayed the same for a while."""
    end = time.time() + seconds
    begin = time.time()
    last, since = screen.picture(), time.time()
    while time.time() < end:
        time.sleep(0.5)
        now = screen.picture()
        if now != last:
            last, since = now, time.time()
        elif time.time() - since > 3 and time.time() - begin > least:
            break
    return last


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("relievo")
    parser.add_argument("out")
    parser.add_argument("files", nargs="+")
    parser.add_argument("--look")
    parser.add_argument("--keys", default="", help="names of keys pressed before the picture")
    parser.add_argument("--size", default="1400x900")
    parser.add_argument("--crop", help="X,Y,WIDTH,HEIGHT: what of the screen is kept")
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--program", nargs="*", default=[], help="further words for the program")
    arguments = parser.parse_args()
    os.makedirs(arguments.out, exist_ok=True)
    failed = 0
    for file in arguments.files:
        screen = Screen(arguments.size)
        with tempfile.TemporaryDirectory() as home:
            program = subprocess.Popen(
                [arguments.relievo, "--safe-mode", file] + arguments.program,
                env=dict(os.environ, DISPLAY=screen.name, HOME=home, XDG_RUNTIME_DIR=home),
                stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, preexec_fn=end_with_parent)
            opened(screen, file, arguments.seconds)
            rgb = settled(screen, arguments.seconds, 6)
            if arguments.look:
                screen.focus()
                screen.key("k", control=True)
                time.sleep(1)
                screen.focus(topmost=True)
                for letter in arguments.look:
                    screen.key("space" if letter == " " else letter)
                time.sleep(0.5)
                screen.key("Return")
                rgb = settled(screen, arguments.seconds, 2)
            if arguments.keys:
                screen.focus()
                for key in arguments.keys.split():
                    screen.key(key)
                rgb = settled(screen, arguments.seconds, 2)
            name = os.path.basename(os.path.dirname(file)) + "_" + os.path.basename(file)
            ok = program.poll() is None
            write_png(os.path.join(arguments.out, name + ".png"),
                      *cropped(rgb, screen.size, arguments.crop))
            print(name, "open" if ok else "THE PROGRAM ENDED", flush=True)
            failed += 0 if ok else 1
            program.terminate()
            try:
                program.wait(10)
            except subprocess.TimeoutExpired:
                program.kill()
                program.wait()
        screen.close()
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
