"""A headless Chromium that is asked through its DevTools pipe: no package is needed."""
import fcntl
import json
import os
import subprocess
import time


def high(descriptor):
    """A copy above those that Chromium wants for itself, 3 and 4."""
    return fcntl.fcntl(descriptor, fcntl.F_DUPFD, 10)


class Program:
    """What a browser's program does for whoever can ask it for a `value`."""

    def wait(self, expression, seconds=90):
        """Until the expression is true; its value, or None."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            found = self.value(expression)
            if found:
                return found
            time.sleep(0.1)
        return None

    def close(self):
        self.process.terminate()
        self.process.wait()


class Browser(Program):
    def __init__(self, chromium, profile):
        (to_read, to_write), (from_read, from_write) = os.pipe(), os.pipe()
        ends = [high(to_read), high(from_write)]
        self.to, self.source, self.rest, self.last = to_write, from_read, b"", 0

        def descriptors_3_and_4():
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        self.process = subprocess.Popen(
            [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", f"--user-data-dir={profile}"],
            preexec_fn=descriptors_3_and_4, pass_fds=(3, 4), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        for end in ends + [to_read, from_write]:
            os.close(end)
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]

    def ask(self, method, session=None, **params):
        self.last += 1
        message = {"id": self.last, "method": method, "params": params}
        if session:
            message["sessionId"] = session
        os.write(self.to, json.dumps(message).encode() + b"\0")
        while True:
            answer = self.hear()
            if answer.get("id") == self.last:
                return answer["result"]

    def hear(self):
        while b"\0" not in self.rest:
            some = os.read(self.source, 1 << 16)
            if not some:
                raise RuntimeError("Chromium ended")
            self.rest += some
        line, self.rest = self.rest.split(b"\0", 1)
        return json.loads(line)

    def open(self, address):
        self.ask("Page.navigate", self.session, url=address)

    def value(self, expression):
        """Of an expression of JavaScript in the page; promises are waited for."""
        answer = self.ask("Runtime.evaluate", self.session, expression=expression, awaitPromise=True, returnByValue=True)
        return answer["result"].get("value")
