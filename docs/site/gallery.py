#!/usr/bin/env python3
"""The gallery: every picture that the examples drew, lesson by lesson. Usage: gallery.py OUT
writes OUT/index.html for the pictures OUT/NN_name/*.png; the site has the same page as gallery.html. It needs Python alone."""
import html
import os
import re
import struct
import sys
from pathlib import Path

import pages
import template

SITE = Path(__file__).resolve().parent
ROOT = SITE.parent.parent
TITLE = "The gallery"
WORDS = "What the examples of the course draw. A picture opens in full size; a title opens its lesson."


def size_of(picture):
    """Width and height of a PNG, from its head."""
    with open(picture, "rb") as file:
        head = file.read(24)
    return struct.unpack(">II", head[16:24]) if head[:8] == b"\x89PNG\r\n\x1a\n" and len(head) == 24 else (0, 0)


def pictures_of(lesson, drawn, kept):
    """What the example drew; of an example that was not run, the pictures of its page."""
    name = Path(lesson.source).stem
    return sorted((drawn / name).glob("*.png")) or sorted((kept / name).glob("*.png"))


def figure(picture, address):
    width, height = size_of(picture)
    caption = html.escape(picture.stem.replace("_", " "))
    small = ' class="small"' if 0 < width < 240 else ""
    return (f'<li><figure><a href="{address}"><img src="{address}" alt="{caption}" width="{width}" height="{height}" loading="lazy"{small}></a>'
            f"<figcaption>{caption}</figcaption></figure></li>")


def prints(lesson, drawn):
    """What the example said when it drew."""
    output = drawn / Path(lesson.source).stem / "output.txt"
    if not output.is_file():
        return ""
    text = html.escape(output.read_text(encoding="utf-8", errors="replace"))
    return f'<details class="prints"><summary>What it prints</summary><pre tabindex="0"><code>{text}</code></pre></details>'


def body(lessons, drawn, kept, page_of, address_of):
    """Sections of families with the lessons' pictures. page_of(lesson) and address_of(lesson, picture): where the links lead."""
    text = []
    for digit, family in pages.FAMILIES.items():
        shown = [(lesson, pictures_of(lesson, drawn, kept)) for lesson in lessons if lesson.number.startswith(digit)]
        shown = [(lesson, pictures) for lesson, pictures in shown if pictures]
        if not shown:
            continue
        text.append(f'<section><h2 id="family-{digit}"><b>{digit}x</b> {family}</h2>')
        for lesson, pictures in shown:
            goal = html.escape(re.sub(r"\s+", " ", pages.plain(lesson.goal)))
            figures = "".join(figure(p, address_of(lesson, p)) for p in pictures)
            text.append(f'<h3 id="{lesson.name}"><a href="{page_of(lesson)}"><b>{lesson.number}</b> {html.escape(lesson.title)}</a></h3>'
                        f'<p>{goal}</p><ul class="pictures">{figures}</ul>{prints(lesson, drawn)}')
        text.append("</section>")
    return "\n".join(text) if text else "<p>There are no pictures yet: ./course examples draws them.</p>"


def main():
    if len(sys.argv) != 2 or sys.argv[1].startswith("-"):
        raise SystemExit(__doc__)
    out = Path(sys.argv[1]).resolve()
    if not out.is_dir():
        raise SystemExit(f"{sys.argv[1]}: is no folder; the gallery needs the pictures' folder")
    lessons = pages.lessons(ROOT)
    site = "site/" if (out / "site/index.html").is_file() else ""

    def page_of(lesson):
        return site + lesson.file if site else os.path.relpath(ROOT / lesson.source, out)
    shown = body([lesson for lesson in lessons if any((out / Path(lesson.source).stem).glob("*.png"))], out, out, page_of,
                 lambda lesson, picture: f"{picture.parent.name}/{picture.name}")
    values = {"pagetitle": TITLE, "style": (SITE / "style.css").read_text(encoding="utf-8"), "kind": "home", "site": site, "nav": site,
              "heading": f"<h1>{TITLE}</h1>", "body": f"<p>{WORDS}</p>{shown}"}
    (out / "index.html").write_text(template.fill(template.read(), values), encoding="utf-8")


if __name__ == "__main__":
    main()
