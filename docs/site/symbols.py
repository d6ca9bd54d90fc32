"""Every symbol of a numbered equation as a link: docs/symbols.toml says what each is, this finds it in the MathML."""
import html
import re
import xml.etree.ElementTree as ElementTree

import pandoc
import values

NAMESPACE = "http://www.w3.org/1998/Math/MathML"
# Words of the formula's language: constants, functions and connectives need no explanation.
PLAIN = {"π", "e", "sin", "cos", "tan", "arccos", "atan", "atan2", "exp", "log", "ln", "max", "min", "lim", "and", "or", "if",
         "for", "else", "unit", "mix", "round", "floor", "where", "with", "∞", "∂", "const", "∅"}


def tag_of(node):
    return node.tag.rpartition("}")[2]


def parse(mathml):
    """The formula below <semantics>, without the annotation."""
    root = ElementTree.fromstring(mathml)
    return root, list(list(root)[0])[0]


def key_of(node):
    """A formula's shape without spaces and brackets that show nothing: equal formulas have equal keys."""
    children = [key_of(c) for c in node if tag_of(c) not in ("mspace", "annotation")]
    name = tag_of(node)
    if name in ("mrow", "mstyle") and len(children) == 1:
        return children[0] if name == "mrow" else (name, node.get("mathvariant"), children[0])
    return (name, (node.text or "").strip(), *children)


def keys_of(node):
    """A symbol's parts: the children of a row, or the node alone."""
    if tag_of(node) == "mrow":
        return [key_of(c) for c in node if tag_of(c) != "mspace"]
    return [key_of(node)]


def leaves_of(node):
    return [n for n in node.iter() if tag_of(n) in ("mi", "mo", "mn", "mtext")]


def is_differential(node):
    return tag_of(node) == "mstyle" and node.get("mathvariant") == "normal" and "".join(node.itertext()) == "d"


class Symbols:
    """The table, checked against the pages as they are converted. `problems` and `resolved` are what the test reads."""

    def __init__(self, root, kreda, places=None):
        self.root, self.problems, self.resolved, self.entries = root, [], 0, []
        file = root / "docs/symbols.toml"
        self.table = values.tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}
        self.pixels = values.Pixels(root, self.table.get("pixel", {}), kreda)
        written = [s for t in self.tables() for s in t]
        self.mathml = pandoc.mathml(written)
        self.keys = {s: keys_of(parse(m)[1]) for s, m in self.mathml.items()}
        self.texts = {}
        self.names = pandoc.names_of(root / "docs/references.bib")
        self.rows, self.places = [], places or {}

    def tables(self):
        yield self.table.get("shared", {})
        for page in self.table.get("page", {}).values():
            yield page.get("symbols", {})

    def known_on(self, page):
        """{LaTeX: entry} of a page; its own entries hide the shared ones."""
        return {**self.table.get("shared", {}), **self.table.get("page", {}).get(page.name, {}).get("symbols", {})}

    def place(self, entry):
        """(file, identifier, line) of "lighting/fog.hpp: fog_exp"; line 0: it is not there."""
        file, _, identifier = entry["code"].partition(": ")
        if file not in self.texts:
            path = self.root / file
            lines = path.read_text(encoding="utf-8").splitlines() if path.is_file() else []
            self.texts[file] = ["" if line.startswith("#include") else line.partition("//")[0] for line in lines]
        word = re.escape(identifier)
        # Where it is defined: a function or type at the line's start, else a member or parameter, else its first use.
        kinds = (rf"^(?:[\w:<>\[\]&]+ )+{word}\(", rf"^(?:struct|class|enum class) {word}\b", rf"\b(?:[\w:<>]+) (?:\w+, )*{word}(?:;|, | =|{{)",
                 rf"(?<!\w){word}(?!\w)")
        for kind in kinds:
            for n, line in enumerate(self.texts[file], 1):
                if re.search(kind, line):
                    return file, identifier, n
        return file, identifier, 0

    def value(self, page, symbol, known, asked=()):
        entry = known[symbol]
        if symbol in asked:
            raise values.NoValue(f"the value of {symbol} asks for itself")
        if "value" not in entry:
            raise values.NoValue("no value is given")
        pixel = entry.get("pixel", self.table.get("page", {}).get(page.name, {}).get("pixel", ""))

        def lookup(other):
            if other not in known:
                raise values.NoValue(f"{other} is no symbol here")
            return self.value(page, other, known, (*asked, symbol))[0]
        return values.find(entry["value"], page, pixel, self.pixels, lookup)

    def describe(self, page, number, symbol, known):
        """What the box of a symbol says; notes what does not resolve."""
        entry, complete = known[symbol], True
        file, identifier, line = self.place(entry)
        if line == 0:
            self.problems.append(f"{page.source} ({number}): {symbol}: {file} has no {identifier}")
            complete = False
        told = ""
        try:
            value, where = self.value(page, symbol, known)
            told = f'<span class="value"><b>{html.escape(values.shown(value))}</b> {html.escape(where)}</span>'
        except values.NoValue as error:
            self.problems.append(f"{page.source} ({number}): {symbol}: {error}")
            complete = False
        self.resolved += complete
        self.rows.append((page, number, symbol, entry, file, identifier, line, told))
        measure = ", ".join(html.escape(entry[k]) for k in ("unit", "range") if entry.get(k))
        source = f'source/{file.replace("/", "--")}.html#L-{line}'
        self.entries.append({"t": f"{entry['is']}", "u": f"{page.file}#eq-{number}", "k": f"symbol, {page.number} {page.title}",
                             "x": f"{symbol} {identifier}"})
        reference = f' <a href="{self.places[identifier]}">reference</a>' if identifier in self.places else ""
        return (f'<span class="is">{html.escape(entry["is"])}</span> '
                f'<a href="{source}"><code>{identifier}</code> {file}:{line}</a>{reference}'
                + (f' <span class="measure">{measure}</span>' if measure else "") + (f" {told}" if told else ""))

    def find_in(self, node, known, found, free, bound):
        """Marks the leaves of known symbols with data-s and puts others' words into `free`."""
        children = [c for c in node if tag_of(c) not in ("mspace", "annotation")]
        keys = [key_of(c) for c in children]
        at = 0
        while at < len(children):
            symbol = self.longest_at(keys, at, known)
            if symbol:
                index = found.setdefault(symbol, len(found))
                width = len(self.keys[symbol])
                for child in children[at:at + width]:
                    for leaf in leaves_of(child):
                        leaf.set("data-s", str(index))
                at += width
                continue
            self.look_inside(children[at], known, found, free, bound)
            at += 1

    def look_inside(self, child, known, found, free, bound):
        if is_differential(child):
            return
        if tag_of(child) in ("mi", "mtext"):
            word = (child.text or "").strip()
            if word and word not in PLAIN and word not in bound and not re.fullmatch(r"[\W\d]+", word):
                free.append(word)
        else:
            self.find_in(child, known, found, free, bound)

    def longest_at(self, keys, at, known):
        fitting = [s for s in known if self.keys[s] == keys[at:at + len(self.keys[s])]]
        return max(fitting, key=lambda s: len(self.keys[s]), default=None)

    def link(self, page, body):
        """The page's HTML with its symbols linked and a box under each numbered equation."""
        known = self.known_on(page)
        settings = self.table.get("page", {}).get(page.name, {})

        def equation(match):
            number, mathml = match.group(2), match.group(3)
            root, formula = parse(mathml)
            found, free = {}, []
            holder = ElementTree.Element("mrow")
            holder.append(formula)
            self.find_in(holder, known, found, free, set(settings.get("bound", [])))
            for word in dict.fromkeys(free):
                self.problems.append(f"{page.source} ({number}): {word}: nothing says what it is")
            text = re.sub(r'<math.*</math>', lambda m: serialized(root, f"eq-{number}"), match.group(0), flags=re.S)
            return text + self.box(page, number, found, known, settings)
        return re.sub(r'<div( id="eq-([^"]+)" class="equation numbered"[^>]*)>\s*(<math.*?</math>).*?</div>', equation, body, flags=re.S)

    def check(self, lessons):
        """Only what the test asks: all equations of the pages, without the pages around them. One run of Pandoc."""
        written = {p.name: re.findall(r"^\s*\$\$(.*?)\s*\\tag\{(\w+)\}\$\$", p.markdown, re.M) for p in lessons}
        mathml = pandoc.mathml([latex for found in written.values() for latex, _ in found])
        for page in lessons:
            self.link(page, "".join(f'<div id="eq-{n}" class="equation numbered">{mathml[latex]}</div>'
                                    for latex, n in written[page.name]))
        self.equations = sum(map(len, written.values()))

    def box(self, page, number, found, known, settings):
        if not found:
            return self.citation(settings, number)
        rows = []
        for symbol, index in found.items():
            rows.append((index, self.mathml[symbol], self.describe(page, number, symbol, known)))
        tips = "".join(f'<div class="tip tip{i}" aria-hidden="true">{m} {text}</div>'.replace("<a ", '<a tabindex="-1" ')
                       for i, m, text in rows)
        listed = "".join(f'<div id="eq-{number}-s{i}"><dt>{m}</dt><dd>{text}</dd></div>' for i, m, text in rows)
        return (f'<div class="tips">{tips}</div><details class="symbols"><summary>Symbols of ({number})</summary>'
                f'<dl>{listed}</dl></details>' + self.citation(settings, number))

    def citation(self, settings, number):
        cite = settings.get("cite", {}).get(number)
        if not cite:
            return ""
        links = []
        for part in cite.split("; "):
            key, _, place = part.partition(", ")
            if key not in self.names:
                self.problems.append(f"docs/symbols.toml cites {key}, which is not in docs/references.bib")
            links.append(f'<a class="cite" href="references.html#ref-{key}">{self.names.get(key, key)}</a>' + (f", {place}" if place else ""))
        return f'<p class="cited">After {"; ".join(links)}</p>'

    def list_of_all(self):
        """A page of every symbol, lesson by lesson."""
        text, last = [], None
        for page, number, symbol, entry, file, identifier, line, told in sorted(self.rows, key=lambda r: (r[0].file, r[1])):
            if page is not last:
                text.append(("</table></div>" if last else "") + f'<h2 id="{page.name}"><a href="{page.file}">{page.number} '
                            f'{html.escape(page.title)}</a></h2><div class="wide" tabindex="0" role="region" aria-label="symbols of '
                            f'{html.escape(page.title)}"><table><tr><th>symbol</th><th>in</th><th>what</th><th>in the code</th>'
                            '<th>value</th></tr>')
                last, seen = page, set()
            if symbol in seen:
                continue
            seen.add(symbol)
            text.append(f'<tr><td>{self.mathml[symbol]}</td><td><a href="{page.file}#eq-{number}">({number})</a></td>'
                        f'<td>{html.escape(entry["is"])}</td><td><a href="source/{file.replace("/", "--")}.html#L-{line}">'
                        f'<code>{identifier}</code></a></td><td>{told}</td></tr>')
        return "\n".join(text) + ("</table></div>" if last else "")

    def report(self):
        total = len(self.entries)
        return f"{self.resolved} of {total} symbols of equations resolve, {len(self.problems)} problems"

    def search_entries(self):
        return self.entries


def serialized(root, where):
    """MathML with its marked leaves as links to the rows of the box."""
    def write(node):
        name = tag_of(node)
        if name == "annotation":
            return f'<annotation encoding="application/x-tex">{html.escape(node.text or "")}</annotation>'
        attributes = "".join(f' {k}="{html.escape(v)}"' for k, v in node.attrib.items() if k != "data-s")
        inner = html.escape(node.text or "") + "".join(write(c) for c in node)
        if node.get("data-s") is not None:
            inner = f'<a class="s s{node.get("data-s")}" tabindex="-1" href="#{where}-s{node.get("data-s")}">{inner}</a>'
        return f"<{name}{attributes}>{inner}</{name}>"
    return write(root)
