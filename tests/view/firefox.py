"""A headless Firefox that is asked through Marionette, its own protocol: no package is needed."""
import json
import socket
import subprocess
import time

from browser import Program


def free_port():
    with socket.socket() as some:
        some.bind(("127.0.0.1", 0))
        return some.getsockname()[1]


class Firefox(Program):
    def __init__(self, firefox, profile):
        profile.mkdir(parents=True, exist_ok=True)
        port = free_port()
        (profile / "user.js").write_text(f'user_pref("marionette.port", {port});\n', encoding="utf-8")
        self.process = subprocess.Popen([firefox, "--headless", "--marionette", "--no-remote", "--profile", str(profile)],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.rest, self.last = b"", 0
        try:
            self.socket = self.connect(port, 240)
            self.read()
            self.ask("WebDriver:NewSession", capabilities={"alwaysMatch": {}})
            self.ask("WebDriver:SetTimeouts", script=240000, pageLoad=240000)
        except BaseException:
            self.close()
            raise

    def connect(self, port, seconds):
        end = time.monotonic() + seconds
        while True:
            try:
                return socket.create_connection(("127.0.0.1", port))
            except OSError:
                if time.monotonic() > end or self.process.poll() is not None:
                    raise
                time.sleep(0.2)

    def read(self):
        """A message: its length in digits, a colon, JSON."""
        while True:
            head, colon, body = self.rest.partition(b":")
            if colon and len(body) >= int(head):
                self.rest = body[int(head):]
                return json.loads(body[:int(head)])
            some = self.socket.recv(1 << 16)
            if not some:
                raise RuntimeError("Firefox ended")
            self.rest += some

    def ask(self, command, **params):
        self.last += 1
        text = json.dumps([0, self.last, command, params]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, answer = self.read()
        if error:
            raise RuntimeError(f"{command}: {error['message']}")
        return answer

    def open(self, address):
        self.ask("WebDriver:Navigate", url=address)

    def value(self, expression):
        """Of an expression of JavaScript in the page; promises are waited for."""
        script = f"const done = arguments[0]; Promise.resolve(window.eval({json.dumps(expression)})).then(v => done(v ?? null), e => done(String(e)))"
        return self.ask("WebDriver:ExecuteAsyncScript", script=script, args=[], newSandbox=False, sandbox=None)["value"]

    def size(self, width, height):
        self.ask("WebDriver:SetWindowRect", width=width, height=height)

    def screenshot(self):
        """Base 64 of a PNG."""
        return self.ask("WebDriver:TakeScreenshot", full=False)["value"]
