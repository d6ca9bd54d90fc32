"""The course as one PDF: all lessons, the glossary and the works cited behind one another, printed by Chromium. It prints twice: the first
print tells on which page each heading stands, the second has these numbers in its table of contents."""
import html
import re
import shutil
import subprocess
import tempfile
from pathlib import Path

import pages

SITE = Path(__file__).resolve().parent
ROOT = SITE.parent.parent
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
BESIDE = (("docs/glossary.md", "Glossary"), ("docs/references.bib", "References"))  # what follows the lessons


def browser():
    return next(filter(None, map(shutil.which, BROWSERS)), None)


def mark(page, place=""):
    return f"{page.name}--{place}" if place else page.name


def on_paper(page, body, within):
    """The body of a page of the site as a chapter; `within`: {file of the site: its page} of the chapters. Links to them stay links,
    links to what paper does not have become their words. Answers are unfolded; what needs a mouse goes."""
    body = re.sub(r'<details class="live">.*?</details>', "", body, flags=re.S)
    body = re.sub(r'<div class="tips">.*?</div>(?=<details class="symbols">)', "", body, flags=re.S)
    body = re.sub(r'<details class="symbols">.*?</details>', "", body, flags=re.S)
    body = body.replace("<details>", "<details open>").replace(' loading="lazy"', "").replace(' tabindex="0"', "")
    ids = set(re.findall(r' id="([^"]+)"', body))

    def link(match):
        address, words = match.group(2), match.group(4)
        file, _, place = address.partition("#")
        if re.match(r"[a-z]+:", address):
            return match.group(0)
        target = page if not file else within.get(file)
        if target is None or (target is page and place and place not in ids):
            return words
        return f'<a{match.group(1)}href="#{mark(target, place)}"{match.group(3)}>{words}</a>'
    body = re.sub(r' id="([^"]+)"', lambda m: f' id="{mark(page, m.group(1))}"', body)
    body = re.sub(r'<a([^>]*? )href="([^"]*)"([^>]*)>(.*?)</a>', link, body, flags=re.S)
    return re.sub(r"<(/?)h([23])\b", lambda m: f"<{m.group(1)}h{int(m.group(2)) + 1}", body)


def with_pictures(text, site):
    return re.sub(r'src="(pictures/[^"]+)"', lambda m: f'src="{(site / m.group(1)).resolve().as_uri()}"', text)


def contents(lessons, beside, page_numbers):
    """The table of contents; a heading whose page is not known yet gets the room for its number."""
    def line(name, words):
        return f'<li><a href="#{name}"><span>{words}</span><span class="dots"></span><span class="page">{page_numbers.get(name, "000")}</span></a></li>'
    text = ['<nav class="contents"><h1>Contents</h1>']
    for digit, family in pages.FAMILIES.items():
        found = [p for p in lessons if p.number.startswith(digit)]
        if found:
            lines = "".join(line(p.name, f"<b>{p.number}</b> {html.escape(p.title)}") for p in found)
            text.append(f"<h2>{family}</h2><ol>{lines}</ol>")
    text.append("<h2>Beside the lessons</h2><ol>" + "".join(line(p.name, html.escape(p.title)) for p in beside) + "</ol></nav>")
    return "".join(text)


def chapters(lessons, beside, bodies, site):
    within = {p.file: p for p in (*lessons, *beside)}
    text, digit = [], ""
    for page in (*lessons, *beside):
        if page.number and page.number[0] != digit:
            digit = page.number[0]
            text.append(f'<h1 class="family" id="family-{digit}">{pages.FAMILIES[digit]}</h1>')
        number = f'<span class="lesson">{page.number}</span> ' if page.number else ""
        level = "h2" if page.number else "h1"
        text.append(f'<section class="chapter"><{level} id="{page.name}">{number}{html.escape(page.title)}</{level}>'
                    f"{on_paper(page, bodies[page.source], within)}</section>")
    return with_pictures("\n".join(text), site)


def cover(cff):
    """Title, authors and licence."""
    authors = re.findall(r'^\s+-? ?name: "?([^"\n]+)"?$', cff, re.M)
    version = re.search(r"^version: (\S+)", cff, re.M)
    return ('<section class="cover"><h1>A rasterizer to teach lighting with</h1><p>Every formula of the lecture is one small C++ function. '
            "Each lesson has its equations, its picture and its numbers.</p><p>"
            + html.escape(", ".join(authors) or "Kreda") + (f", version {version.group(1)}" if version else "")
            + ". Text and pictures: CC BY 4.0; code: MIT.</p></section>")


def document(lessons, beside, bodies, site, page_numbers):
    style = (SITE / "style.css").read_text(encoding="utf-8") + (SITE / "paper.css").read_text(encoding="utf-8")
    front = cover((ROOT / "CITATION.cff").read_text(encoding="utf-8")) + contents(lessons, beside, page_numbers)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8"><title>Kreda: a rasterizer to teach lighting with</title>'
            f"<style>{style}</style></head><body><main>{front}{chapters(lessons, beside, bodies, site)}</main></body></html>\n")


def pages_of(pdf):
    """{name of a place: its page, from 1}, from the objects of a PDF as Chromium writes it."""
    objects = {int(n): body for n, body in re.findall(rb"^(\d+) 0 obj\n(.*?)\nendobj", pdf, re.S | re.M)}

    def leaves(number):
        kids = re.search(rb"/Kids \[(.*?)\]", objects[number], re.S)
        return [leaf for kid in re.findall(rb"(\d+) 0 R", kids.group(1)) for leaf in leaves(int(kid))] if kids else [number]
    roots = [n for n, body in objects.items() if re.search(rb"/Type /Pages\b", body) and not re.search(rb"/Parent ", body)]
    order = {leaf: i for root in roots for i, leaf in enumerate(leaves(root), 1)}
    places = {}
    for body in objects.values():
        for name, page in re.findall(rb"/([^\s/\[\]<>()]+) \[(\d+) 0 R /XYZ", body):
            name = re.sub(rb"#([0-9a-fA-F]{2})", lambda m: bytes([int(m.group(1), 16)]), name)
            if int(page) in order:
                places[name.decode("utf-8", "replace")] = order[int(page)]
    return places


def print_page(program, text, to):
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "course.html"
        page.write_text(text, encoding="utf-8")
        done = subprocess.run([program, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={folder}/profile", "--no-pdf-header-footer",
                               "--generate-pdf-document-outline", "--allow-file-access-from-files", f"--print-to-pdf={to}", page.as_uri()],
                              capture_output=True, text=True)
        if done.returncode != 0 or not to.is_file():
            raise SystemExit(f"docs: {program} printed nothing: {done.stderr.strip()[-300:]}")


def write(site, lessons, found, bodies, to):
    """The course as the PDF `to`; the number of its pages. bodies: {source: HTML}; found: all pages of the site."""
    program = browser()
    beside = [pages.Page(p.source, p.file, title) for source, title in BESIDE for p in found if p.source == source]
    to.parent.mkdir(parents=True, exist_ok=True)
    to.unlink(missing_ok=True)
    print_page(program, document(lessons, beside, bodies, site, {}), to)
    places = pages_of(to.read_bytes())
    missing = [p.name for p in (*lessons, *beside) if p.name not in places]
    if missing:
        raise SystemExit(f"docs: no page of the PDF is known for {', '.join(missing)}")
    print_page(program, document(lessons, beside, bodies, site, places), to)
    if pages_of(to.read_bytes()) != places:
        raise SystemExit("docs: the table of contents moved the pages that it names")
    return max(places.values())
