#!/usr/bin/env python3
"""Serves a folder, the site, to this machine's browsers until Ctrl+C. Usage: serve.py FOLDER [PORT]

It sends the two headers without which a browser lets no threads share memory ("cross-origin isolation"): with them live
figures draw in all cores."""
import functools
import http.server
import sys
from pathlib import Path


class Isolated(http.server.SimpleHTTPRequestHandler):
    def end_headers(self):
        self.send_header("Cross-Origin-Opener-Policy", "same-origin")
        self.send_header("Cross-Origin-Embedder-Policy", "require-corp")
        self.send_header("Cache-Control", "no-cache")  # a site that was made anew is seen
        super().end_headers()

    def log_message(self, *_):
        pass


def server(folder, port=0):
    """Of this machine alone; port 0: any that is free."""
    return http.server.ThreadingHTTPServer(("127.0.0.1", port), functools.partial(Isolated, directory=folder))


def main():
    if len(sys.argv) not in (2, 3) or not Path(sys.argv[1]).is_dir() or not (sys.argv + ["", "0"])[2].isdigit():
        raise SystemExit(__doc__)
    port = int(sys.argv[2]) if len(sys.argv) == 3 else 8000
    try:
        site = server(sys.argv[1], port)
    except OSError as error:
        raise SystemExit(f"serve: port {port}: {error.strerror}; name another one")
    print(f"http://localhost:{site.server_port}/index.html (end it with Ctrl+C)", flush=True)
    try:
        site.serve_forever()
    except KeyboardInterrupt:
        print()


if __name__ == "__main__":
    main()
