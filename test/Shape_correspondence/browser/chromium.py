# Copyright (c) 2026 the Shape_correspondence developers. All rights reserved.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Chromium without a window, by its remote debugging protocol over a pipe. Needs nothing but Python."""
import base64
import fcntl
import json
import os
import shutil
import subprocess
import tempfile
import time

SECONDS = 60  # limit for every wait


def find():
    """The browser's path, or None."""
    return next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)


def _above_9(descriptor):
    """Moves a descriptor to a number above 9, so that 3 and 4 are free."""
    copy = fcntl.fcntl(descriptor, fcntl.F_DUPFD, 10)
    os.close(descriptor)
    return copy


class Browser:
    def __init__(self, path, *options):
        self.profile = tempfile.mkdtemp()
        read_here, write_there = map(_above_9, os.pipe())
        read_there, write_here = map(_above_9, os.pipe())

        def connect():  # the browser reads from 3 and writes to 4
            os.dup2(read_there, 3)
            os.dup2(write_there, 4)
        arguments = [path, "--headless=new", "--no-sandbox", "--remote-debugging-pipe", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--allow-file-access-from-files",
                     "--hide-scrollbars", "--force-prefers-reduced-motion", "--user-data-dir=" + self.profile, *options, "about:blank"]
        self.process = subprocess.Popen(arguments, preexec_fn=connect, pass_fds=(3, 4), stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
        os.close(read_there)
        os.close(write_there)
        self.out, self.into = open(read_here, "rb", 0), open(write_here, "wb", 0)
        self.rest, self.number, self.events = b"", 0, []
        self.contexts = {}  # identifiers of the execution contexts of frames
        self.session = None
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def _message(self):
        while b"\0" not in self.rest:
            more = self.out.read(1 << 20)
            if not more:
                raise RuntimeError("the browser ended")
            self.rest += more
        text, self.rest = self.rest.split(b"\0", 1)
        return json.loads(text)

    def call(self, method, **parameters):
        self.number += 1
        request = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            request["sessionId"] = self.session
        self.into.write(json.dumps(request).encode() + b"\0")
        while True:
            message = self._message()
            if message.get("id") == self.number:
                if "error" in message:
                    raise RuntimeError(f"{method}: {message['error']['message']}")
                return message["result"]
            if message["method"] == "Runtime.executionContextCreated":
                context = message["params"]["context"]
                self.contexts[context["auxData"]["frameId"]] = context["id"]
            self.events.append(message)

    def inner_frame(self):
        """The identifier of the only frame in the page."""
        return self.call("Page.getFrameTree")["frameTree"]["childFrames"][0]["frame"]["id"]

    def evaluate(self, expression, frame=None):
        context = {"contextId": self.contexts[frame]} if frame else {}
        result = self.call("Runtime.evaluate", expression=expression, awaitPromise=True, returnByValue=True, **context)
        if "exceptionDetails" in result:
            raise RuntimeError(str(result["exceptionDetails"]))
        return result["result"].get("value")

    def wait_for(self, expression, frame=None):
        end = time.monotonic() + SECONDS
        while time.monotonic() < end:
            value = self.evaluate(expression, frame)
            if value:
                return value
            time.sleep(0.05)
        raise RuntimeError("never true: " + expression)

    def allow_motion(self, is_allowed):
        """Sets whether pages may move by themselves; at first they may not."""
        self.call("Emulation.setEmulatedMedia", features=[{"name": "prefers-reduced-motion", "value": "no-preference" if is_allowed else "reduce"}])

    def resize(self, width, height, is_phone=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=is_phone)
        self.call("Emulation.setTouchEmulationEnabled", enabled=is_phone)

    def open(self, file):
        """Opens a file, or an address. Returns the errors, and the addresses of all other requests."""
        self.events = []
        self.url = file if "://" in file else "file://" + os.path.abspath(file)
        self.call("Page.navigate", url=self.url)
        self.wait_for("document.readyState === 'complete'")
        return self.heard()

    def heard(self):
        """The errors since the page was opened, and the addresses of all other requests."""
        errors = [e["params"] for e in self.events if e["method"] == "Runtime.exceptionThrown"
                  or (e["method"] == "Log.entryAdded" and e["params"]["entry"]["level"] == "error")]
        requests = [e["params"]["request"]["url"] for e in self.events if e["method"] == "Network.requestWillBeSent"]
        return errors, [r for r in requests if r != self.url]

    def drop(self, x, y, files):
        data = {"items": [], "files": [os.path.abspath(file) for file in files], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.call("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)

    def mouse(self, kind, x, y, button="none", **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button=button, clickCount=int(button != "none"), **more)

    def click(self, x, y):
        self.mouse("mouseMoved", x, y)
        self.mouse("mousePressed", x, y, "left", buttons=1)
        self.mouse("mouseReleased", x, y, "left")

    def tap(self, x, y):
        self.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=[{"x": x, "y": y}])
        self.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])

    def screenshot(self, **options):
        """A picture as PNG."""
        return base64.b64decode(self.call("Page.captureScreenshot", format="png", **options)["data"])
