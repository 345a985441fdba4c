# SPDX-License-Identifier: BSD-3-Clause
"""Chromium without a screen, led over two pipes (its DevTools protocol); nothing is waited for by the clock."""
import base64
import json
import os
import struct
import subprocess
import tempfile
import zlib


class Browser:
    def __init__(self, program):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_read, self.to_write = os.pipe()
        self.from_read, from_write = os.pipe()
        # The browser reads from 3 and writes to 4; first out of the way of these numbers.
        ends = [os.dup(to_read), os.dup(from_write)]
        high = [os.dup2(end, 60 + i) for i, end in enumerate(ends)]
        command = [program, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run",
                   "--disable-extensions", "--disable-dev-shm-usage", "--remote-debugging-pipe",
                   "--user-data-dir=" + self.folder.name, "about:blank"]
        self.process = subprocess.Popen(
            command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, pass_fds=(3, 4),
            env=dict(os.environ, HOME=self.folder.name),
            preexec_fn=lambda: (os.dup2(high[0], 3), os.dup2(high[1], 4)))
        for end in [to_read, from_write] + ends + high:
            os.close(end)
        self.rest = b""
        self.number = 0
        self.session = None
        self.complaints = []
        self.loaded = set()
        pages = [t for t in self.ask("Target.getTargets")["targetInfos"] if t["type"] == "page"]
        self.session = self.ask("Target.attachToTarget", targetId=pages[0]["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(domain + ".enable")
        self.ask("Page.setLifecycleEventsEnabled", enabled=True)

    def close(self):
        try:
            self.session = None
            self.ask("Browser.close")
        except (OSError, EOFError):
            pass
        self.process.wait()
        os.close(self.to_write)
        os.close(self.from_read)
        self.folder.cleanup()

    def ask(self, method, **parameters):
        self.number += 1
        number = self.number
        message = {"id": number, "method": method, "params": parameters}
        if self.session:
            message["sessionId"] = self.session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to_write, data):]
        while True:
            answer = self._next()
            if answer.get("id") == number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def _next(self):
        while b"\0" not in self.rest:
            some = os.read(self.from_read, 1 << 16)
            if not some:
                raise EOFError("Chromium ended.")
            self.rest += some
        line, self.rest = self.rest.split(b"\0", 1)
        message = json.loads(line)
        self._note(message.get("method"), message.get("params", {}))
        return message

    def _note(self, event, about):
        """What a reader with an open console would see, and how far pages are."""
        if event == "Runtime.exceptionThrown":
            self.complaints.append(json.dumps(about["exceptionDetails"])[:400])
        elif event == "Log.entryAdded" and about["entry"]["level"] in ("error", "warning"):
            self.complaints.append(about["entry"]["text"] + " " + about["entry"].get("url", ""))
        elif event == "Network.loadingFailed":
            self.complaints.append("not loaded: " + about.get("errorText", ""))
        elif event == "Network.requestWillBeSent" and not about["request"]["url"].startswith(("file:", "data:")):
            self.complaints.append("asked the network: " + about["request"]["url"])
        elif event == "Page.lifecycleEvent" and about["name"] == "load":
            self.loaded.add(about["loaderId"])

    def go(self, url):
        answer = self.ask("Page.navigate", url=url)
        if answer.get("errorText"):
            raise RuntimeError(f"{url}: {answer['errorText']}")
        loader = answer.get("loaderId")
        while loader and loader not in self.loaded:
            self._next()

    def value(self, script):
        """Of a promise, what it brings."""
        result = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(json.dumps(result["exceptionDetails"])[:400])
        return result["result"].get("value")

    def size(self, width, height):
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def prefer(self, scheme):
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])

    def picture(self):
        return base64.b64decode(self.ask("Page.captureScreenshot", format="png")["data"])


def luminances(png):
    """Rows of 0 to 255; of PNGs with 8 bits as browsers write them."""
    at, data = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        chunk = png[at + 8:at + 8 + length]
        at += 12 + length
        if kind == b"IHDR":
            width, height, _, colours = struct.unpack(">IIBB", chunk[:10])
        elif kind == b"IDAT":
            data += chunk
    step = {2: 3, 6: 4}[colours]
    data, before, rows = zlib.decompress(data), bytearray(width * step), []
    for y in range(height):
        start = y * (width * step + 1)
        row = bytearray(data[start + 1:start + 1 + width * step])
        _undo_filter(data[start], row, before, step)
        rows.append([(2 * row[i] + 5 * row[i + 1] + row[i + 2]) // 8 for i in range(0, len(row), step)])
        before = row
    return rows


def _undo_filter(kind, row, above, step):
    if kind == 0:
        return
    for i, value in enumerate(row):
        left = row[i - step] if i >= step else 0
        up = above[i]
        if kind == 1:
            guess = left
        elif kind == 2:
            guess = up
        elif kind == 3:
            guess = (left + up) // 2
        else:
            corner = above[i - step] if i >= step else 0
            away = [abs(up - corner), abs(left - corner), abs(left + up - 2 * corner)]
            guess = (left, up, corner)[away.index(min(away))]
        row[i] = (value + guess) & 255
