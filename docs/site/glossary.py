"""Terms in four languages: docs/glossary.md is the table; the first use of a term on a page leads to its row."""
import html
import re


class Glossary:
    def __init__(self, root):
        self.terms = {}  # English term in lower case -> (row's id, [the other languages])
        path = root / "docs/glossary.md"
        if not path.exists():
            return
        for line in path.read_text(encoding="utf-8").splitlines():
            cells = [c.strip() for c in line.strip("|").split("|")]
            if line.startswith("| ") and len(cells) >= 4 and not cells[0].startswith(("---", "English")):
                term = re.sub(r"<[^>]+>", "", cells[0]).strip()
                self.terms[term.lower()] = (re.sub(r"\W+", "-", term.lower()).strip("-"), [c.strip("*") for c in cells[1:4]])

    def pattern(self):
        words = sorted((re.escape(t) for t in self.terms), key=len, reverse=True)
        return re.compile(r"(?<![\w-])(" + "|".join(words) + r")(s?)(?![\w-])", re.I) if words else None

    def link(self, page, body):
        if page.source == "docs/glossary.md":
            return self.with_marks(body)
        if not self.terms or not page.number:
            return body
        used, pattern = set(), self.pattern()

        def first(match):
            mark, others = self.terms[match.group(1).lower()]
            if mark in used:
                return match.group(0)
            used.add(mark)
            title = html.escape(" · ".join(o for o in others if o not in ("", "–")), quote=True)
            return f'<a class="term" href="glossary.html#{mark}" title="{title}">{match.group(0)}</a>'
        # Only words of paragraphs and lists: no code, formula, link, heading or caption.
        text, inside = [], 0
        for part in re.split(r"(<[^>]+>)", body):
            tag = re.match(r"<(/?)(a|code|pre|math|h[1-6]|figure|summary|table|style)\b", part)
            if tag:
                inside += -1 if tag.group(1) else 1
            text.append(pattern.sub(first, part) if inside == 0 and not part.startswith("<") else part)
        return "".join(text)

    def with_marks(self, body):
        """The rows of the glossary's own page get their ids."""
        def row(match):
            term = re.sub(r"<[^>]+>", "", match.group(1)).strip().lower()
            mark = self.terms.get(html.unescape(term), ("",))[0]
            return f'<tr id="{mark}">\n<td>{match.group(1)}</td>' if mark else match.group(0)
        return re.sub(r"<tr[^>]*>\s*<td[^>]*>(.*?)</td>", row, body, flags=re.S)

    def search_entries(self):
        return [{"t": term, "u": f"glossary.html#{mark}", "k": "term", "x": " ".join(others)}
                for term, (mark, others) in self.terms.items()]
