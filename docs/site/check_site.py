#!/usr/bin/env python3
"""Is a built site whole? Usage: check_site.py FOLDER. Every link leads to a file and, with #, to an id of it; every picture is there and has
words; no id comes twice; nothing is asked of the network. One line a fault; exit code 1 if there are any."""
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote


class Reader(HTMLParser):
    """Ids, links and pictures of a page."""

    def __init__(self):
        super().__init__()
        self.ids, self.links, self.loads, self.faults, self.level = [], [], [], [], 0

    def handle_starttag(self, tag, attrs):
        attrs = dict(attrs)
        if attrs.get("id"):
            self.ids.append(attrs["id"])
        if tag == "a" and attrs.get("href"):
            self.links.append(attrs["href"])
        if tag in ("img", "script") and attrs.get("src"):
            self.loads.append(attrs["src"])
        if tag == "link" and attrs.get("href"):
            self.loads.append(attrs["href"])
        if tag == "img" and "alt" not in attrs:
            self.faults.append(f"a picture without words: {attrs.get('src')}")
        if re.fullmatch("h[1-6]", tag):
            level = int(tag[1])
            if level > self.level + 1 and self.level > 0:
                self.faults.append(f"a heading of level {level} after one of level {self.level}")
            self.level = level


def check(folder):
    pages = {}
    for file in sorted(f for f in folder.rglob("*.html") if f.relative_to(folder).parts[0] not in ("api", "live")):  # Doxygen's and kreda view's own
        pages[file] = Reader()
        pages[file].feed(file.read_text(encoding="utf-8"))
    faults, links = [], 0
    for file, page in pages.items():
        name = file.relative_to(folder)
        faults += [f"{name}: {fault}" for fault in page.faults]
        faults += [f"{name}: the id {i} comes twice" for i in sorted({i for i in page.ids if page.ids.count(i) > 1})]
        for address in page.loads:
            if re.match(r"[a-z]+:|//", address):
                faults.append(f"{name}: loads {address} from the network")
            elif not (file.parent / unquote(address)).is_file():
                faults.append(f"{name}: {address} is not there")
        for address in page.links:
            links += 1
            if re.match(r"[a-z]+:", address):
                continue
            path, _, mark = unquote(address).partition("#")
            target = (file.parent / path).resolve() if path else file
            if not target.is_file():
                faults.append(f"{name}: the link {address} leads nowhere")
            elif mark and target in pages and mark not in pages[target].ids:
                faults.append(f"{name}: the link {address} leads to no place of its page")
    return pages, links, faults


def main():
    if len(sys.argv) != 2 or sys.argv[1] in ("-h", "--help"):
        raise SystemExit(__doc__)
    pages, links, faults = check(Path(sys.argv[1]).resolve())
    print("\n".join(faults[:60]))
    print(f"{len(pages)} pages, {links} links, {len(faults)} faults")
    raise SystemExit(1 if faults or not pages else 0)


if __name__ == "__main__":
    main()
