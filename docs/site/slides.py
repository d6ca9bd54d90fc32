#!/usr/bin/env python3
"""Slides of a lesson: its pictures, its numbered equations, its source.

    docs/site/slides.py --out out 22_phong_terms              from out/22_phong_terms/*.png and docs/22_phong_terms.md
    docs/site/slides.py --out out --deck "Local illumination" 20_lights 21_lambert ...

Writes OUT/NAME/slides/1.png ... and OUT/NAME/slides.pdf, letters and equations in the PDF as such; with --deck all the
lessons in one file, OUT/slides/TITLE.pdf. Matplotlib sets the equations (Debian: python3-matplotlib)."""
import argparse
import os
import re
import sys
import textwrap
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import pages  # noqa: E402

try:
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot as plt
    from matplotlib.backends.backend_pdf import PdfPages
except ModuleNotFoundError:
    DEBIANS = "/usr/bin/python3"  # has what apt-get installed, where another one comes first in the path
    if Path(DEBIANS).exists() and Path(sys.executable).resolve() != Path(DEBIANS).resolve():
        os.execv(DEBIANS, [DEBIANS, *sys.argv])
    sys.exit(f"slides: {sys.executable} has no matplotlib, which sets the equations "
             "(apt-get install python3-matplotlib, or pip install matplotlib)")

ROOT = Path(__file__).resolve().parents[2]
WIDTH, HEIGHT = 1920, 1080
MARGIN = 0.031  # of the width
LEAST = HEIGHT / 30  # size of letters, pixels
LARGEST_EQUATION = 60
THEMES = {"dark": {"ground": "#20262b", "ink": "#f2eee4", "faint": "#a8b1b7", "accent": "#f2d16b"},
          "light": {"ground": "#fbf9f3", "ink": "#20262b", "faint": "#5a656c", "accent": "#9a6700"}}


class SlideError(RuntimeError):
    """What the user can mend."""


def plain(markdown):
    """A line of Markdown as text."""
    text = re.sub(r"<!--.*?-->", "", markdown)
    text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", text)
    return re.sub(r"\s+", " ", re.sub(r"\*+|`", "", text)).strip()


def numbered_equations(markdown):
    """[(number, LaTeX)] of the page, in its order."""
    found = re.findall(r"^\$\$(.*?)\\tag\{(\w+)\}\s*\$\$", markdown, re.S | re.M)
    return [(number, " ".join(latex.split())) for latex, number in found]


def pictures_of(markdown):
    """[(path below docs/images, caption)] of the page, in its order."""
    return [(path, plain(text)) for text, path in re.findall(r"!\[([^\]]*)\]\(images/([^)]+)\)", markdown)]


def sources_of(markdown):
    section = re.search(r"^## Sources\n(.*?)(?=^## |\Z)", markdown, re.S | re.M)
    return plain(section.group(1)).replace(" * ", " ") if section else ""


def mathtext(latex):
    """What matplotlib's mathtext reads: a part of LaTeX, without \\text."""
    def words(match):
        return r"\mathrm{" + match.group(1).replace(" ", r"\ ") + "}"
    text = re.sub(r"\\(?:text|mathrm)\{([^{}]*)\}", words, latex)
    text = re.sub(r"\\operatorname\{([^}]*)\}", r"\\mathrm{\1}\\,", text)
    text = re.sub(r"\\(le|ge)(?![a-zA-Z])", r"\\\1q", text)
    text = re.sub(r"\\frac(?![a-zA-Z])", r"\\dfrac", text)
    # A subscript or exponent must stand in braces before a macro with an argument.
    text = re.sub(r"([_^])(\\math\w+\{[^{}]*\})", r"\1{\2}", text)
    return "$" + text + "$"


def split(latex):
    """The parts of an equation that is too long for a line, where it has wide gaps or, at last, a sign at depth 0."""
    parts = [p for p in re.split(r",?\s*\\qquad\s*|,\s*\\quad\s*", latex) if p]
    if len(parts) > 1:
        return parts
    depth, places, at = 0, [], 0
    for at, c in enumerate(latex):
        depth += c in "{(" or latex.startswith(r"\left", at)
        depth -= c in "})" or latex.startswith(r"\right", at) and not latex.startswith(r"\rightarrow", at)
        if depth == 0 and c in "=+" and 0 < at:
            places.append(at)
    if not places:
        return [latex]
    middle = min(places, key=lambda p: abs(p - len(latex) / 2))
    return [latex[:middle], r"\quad " + latex[middle:]]


class Slide:
    """One page; positions in pixels, y down."""

    def __init__(self, theme, title, footer):
        self.colors = THEMES[theme]
        matplotlib.rcParams.update({"pdf.fonttype": 42, "font.family": "DejaVu Sans", "mathtext.fontset": "stix"})
        self.figure = plt.figure(figsize=(WIDTH / 100, HEIGHT / 100), dpi=100, facecolor=self.colors["ground"])
        self.left, self.right = MARGIN * WIDTH, (1 - MARGIN) * WIDTH
        self.texts = []
        self.write(title, self.left, 62, 58, "accent")
        self.write(self.cut(footer), self.left, HEIGHT - 34, LEAST, "faint")

    def size_of(self, text):
        box = text.get_window_extent(self.figure.canvas.get_renderer())
        return box.width, box.height

    def write(self, text, x, y, size, color="ink", ha="left"):
        """A line whose middle is at y; smaller where it would leave the slide."""
        drawn = self.figure.text(x / WIDTH, 1 - y / HEIGHT, text, fontsize=size * 0.72, color=self.colors[color], ha=ha,
                                 va="center_baseline")
        room = self.right - x if ha == "left" else self.right - self.left
        width, _ = self.size_of(drawn)
        if width > room:
            drawn.set_fontsize(drawn.get_fontsize() * room / width)
        self.texts.append(drawn)
        return drawn

    def cut(self, text):
        """As many works of a list of sources as a line has room for."""
        works = text.split("; ")
        for count in range(len(works), 0, -1):
            line = "; ".join(works[:count]) + (" …" if count < len(works) else "")
            if len(line) < 92:
                return line
        return textwrap.shorten(text, 92, placeholder=" …")

    def paragraph(self, text, y, size, color="ink"):
        """Lines in the middle from y downward."""
        for line in textwrap.wrap(text, int((self.right - self.left) / (0.6 * size))):
            self.write(line, WIDTH / 2, y, size, color, "center")
            y += 1.35 * size
        return y

    def picture(self, file, top, bottom):
        image = plt.imread(file)
        high, wide = image.shape[:2]
        scale = min((self.right - self.left) / wide, (bottom - top) / high)
        w, h = scale * wide, scale * high
        axes = self.figure.add_axes([(WIDTH - w) / 2 / WIDTH, 1 - (top + (bottom - top - h) / 2 + h) / HEIGHT, w / WIDTH,
                                     h / HEIGHT])
        axes.imshow(image, interpolation="lanczos" if scale < 1 else "nearest", aspect="auto")
        axes.axis("off")

    def equation_lines(self, latex, size):
        """The equation's lines, with the size at which they have room."""
        room = self.right - self.left - 160
        for lines in ([latex], split(latex), [p for part in split(latex) for p in split(part)]):
            drawn = [self.figure.text(0, 0, mathtext(line), fontsize=size * 0.72) for line in lines]
            widest = max(self.size_of(text)[0] for text in drawn)
            highest = max(self.size_of(text)[1] for text in drawn)
            for text in drawn:
                text.remove()
            fits = min(size, size * room / widest)
            if fits >= 0.75 * size:
                break
        return lines, fits, highest * fits / size

    def equations(self, numbered):
        laid = [(number, *self.equation_lines(latex, LARGEST_EQUATION)) for number, latex in numbered]
        needed = sum(len(lines) * (height + 26) for _, lines, _, height in laid)
        gap = (HEIGHT - 140 - 90 - needed) / (len(laid) + 1)
        y = 130 + gap
        for number, lines, size, height in laid:
            middle = y + 0.5 * len(lines) * (height + 26)
            self.write(f"({number})", self.right, middle, 44, "faint", "right")
            for line in lines:
                text = self.figure.text((self.left + 60) / WIDTH, 1 - (y + 0.5 * (height + 26)) / HEIGHT, mathtext(line),
                                        fontsize=size * 0.72, color=self.colors["ink"], va="center")
                self.texts.append(text)
                y += height + 26
            y += gap

    def faults(self):
        """What is cut off or smaller than it should be."""
        found = []
        for text in self.texts:
            box = text.get_window_extent(self.figure.canvas.get_renderer())
            if box.x0 < 0 or box.y0 < 0 or box.x1 > WIDTH or box.y1 > HEIGHT:
                found.append(f"'{text.get_text()}' leaves the slide")
            if text.get_fontsize() / 0.72 < 0.75 * LEAST:
                found.append(f"'{text.get_text()}' is too small")
        return found


def on_slides(equations, theme):
    """Groups of equations that have room on a slide each."""
    groups, room = [], 0
    probe = Slide(theme, "", "")
    for number, latex in equations:
        lines, _, height = probe.equation_lines(latex, LARGEST_EQUATION)
        needed = len(lines) * (height + 26) + 50
        if not groups or needed > room:
            groups.append([])
            room = HEIGHT - 240
        groups[-1].append((number, latex))
        room -= needed
    plt.close(probe.figure)
    return groups


def slides_of(name, out, theme):
    """The slides of a lesson, one after another."""
    page = ROOT / "docs" / f"{name}.md"
    if not page.exists():
        raise SlideError(f"{page}: there is no such page")
    markdown = page.read_text(encoding="utf-8")
    read = pages.read_page(ROOT, f"docs/{name}.md")
    title, footer = f"{read.number} {read.title}", sources_of(markdown)
    for i, (path, caption) in enumerate(pictures_of(markdown)):
        file = out / path
        if not path.startswith(name):  # no example draws it: a picture that stands beside the pages
            file = ROOT / "docs" / "images" / path
        if not file.exists():
            raise SlideError(f"{file}: there is no such picture; draw it first: build/release/bin/{name} --out {out}")
        slide = Slide(theme, title, footer)
        text = plain(read.goal) if i == 0 else caption
        lines = len(textwrap.wrap(text, int((slide.right - slide.left) / (0.6 * 40))))
        slide.picture(file, 110, HEIGHT - 76 - 54 * lines - 8)
        slide.paragraph(text, HEIGHT - 76 - 54 * lines + 30, 40)
        yield slide
    for group in on_slides(numbered_equations(markdown), theme):
        slide = Slide(theme, title, footer)
        slide.equations(group)
        yield slide


def write(name, out, theme, deck=None):
    """All slides of a lesson as PNG files, and as pages of its PDF and of the deck. Returns what is wrong with them."""
    folder = out / name / "slides"
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.glob("*.png"):
        old.unlink()
    faults = []
    with PdfPages(out / name / "slides.pdf") as pdf:
        for i, slide in enumerate(slides_of(name, out, theme), 1):
            faults += [f"{name}, slide {i}: {fault}" for fault in slide.faults()]
            slide.figure.savefig(folder / f"{i}.png", dpi=100, facecolor=slide.figure.get_facecolor())
            for file in filter(None, (pdf, deck)):
                file.savefig(slide.figure, facecolor=slide.figure.get_facecolor())
            plt.close(slide.figure)
    return faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", metavar="NAME", help="a lesson: 22_phong_terms")
    parser.add_argument("--out", default="out", type=Path, help="folder with the lessons' pictures (default: out)")
    parser.add_argument("--theme", default="dark", choices=sorted(THEMES))
    parser.add_argument("--deck", metavar="TITLE", help="one PDF of all these lessons, too: OUT/slides/TITLE.pdf")
    options = parser.parse_args()
    faults, deck = [], None
    try:
        if options.deck:
            file = options.out / "slides" / (options.deck.replace(" ", "_").replace(",", "").lower() + ".pdf")
            file.parent.mkdir(parents=True, exist_ok=True)
            deck = PdfPages(file)
        for name in options.names:
            faults += write(name, options.out, options.theme, deck)
            print(f"{name}: {options.out / name}/slides/ and slides.pdf")
        if deck:
            deck.close()
            print(f"{options.deck}: {file}")
    except SlideError as error:
        sys.exit(str(error))
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
