"""Where the number beside a symbol comes from: a pixel that `kreda explain` tells, a page's debugger session, a checked number.

A value is written in docs/symbols.toml as one of
  explain D             the symbol D of the page's pixel; "explain light_0/s" names the section, "explain q[1]" a part of it
  channel n_dot_l       a channel of the page's pixel
  row spaces/object     a row of a table of the page's pixel; "row view_from_world" a whole matrix
  scene light.0.position what the scene file of the page's pixel says; "scene light.0.attenuation[2]" a part of it
  session print n       what gdb printed for that command on the page; "session n_dot_l" a line "n_dot_l = ..." of it
  number peak           the page's mark <!-- number: peak = ... -->
  calc 2*pi/4           worked out here; {x} is the value of symbol x of the same page
CTest replays the sessions and checks the marks, so each of them is a number that a program computed.
"""
import json
import math
import re
import subprocess

try:
    import tomllib
except ImportError as absent:  # Python before 3.11
    raise SystemExit("docs: Python 3.11 or newer is needed, for its tomllib") from absent

NAMES = {name: getattr(math, name) for name in ("pi", "e", "sqrt", "exp", "log", "log2", "cos", "sin", "tan", "acos",
                                                "atan", "atan2", "radians", "degrees", "hypot", "floor")}
NAMES.update(tuple=tuple, max=max, min=min, abs=abs, sum=sum, dot=lambda a, b: sum(x * y for x, y in zip(a, b)))


class NoValue(Exception):
    pass


def shown(value):
    """Six digits at most, vectors in brackets."""
    if isinstance(value, (list, tuple)):
        return "(" + ", ".join(shown(v) for v in value) + ")"
    if isinstance(value, float) and value.is_integer() and abs(value) < 1e9:
        value = int(value)
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def parsed(text):
    """"(0, 1, 0)" -> [0.0, 1.0, 0.0], "0.5" -> 0.5; other words as they are."""
    number = r"-?(?:\d+\.?\d*(?:e[-+]?\d+)?)"
    if re.fullmatch(number, text):
        return float(text)
    if re.fullmatch(rf"\({number}(?:, {number})*\)", text):
        return [float(part) for part in text[1:-1].split(", ")]
    return text


class Pixels:
    """The pixels of symbols.toml, explained once each."""

    def __init__(self, root, table, kreda):
        self.root, self.table, self.kreda, self.told = root, table, kreda, {}

    def explain(self, name):
        if name not in self.table:
            raise NoValue(f"there is no pixel '{name}'")
        if name not in self.told:
            entry = self.table[name]
            if not self.kreda.exists():
                raise NoValue(f"{self.kreda} is not built")
            command = [str(self.kreda), "explain", str(self.root / entry["scene"]), "--pixel",
                       ",".join(map(str, entry["at"])), "--format", "json", "--no-cache"]
            done = subprocess.run(command, capture_output=True, text=True, encoding="utf-8")
            if done.returncode != 0:
                raise NoValue(done.stderr.strip())
            self.told[name] = json.loads(done.stdout)
        return self.told[name]

    def symbol(self, name, wanted):
        section, _, symbol = wanted.rpartition("/")
        symbol, part = re.fullmatch(r"(.*?)(?:\[(\d+)\])?", symbol).groups()
        for told in self.explain(name)["sections"]:
            if section not in ("", told["id"]):
                continue
            for item in told["items"]:
                if item.get("symbol") == symbol and "value" in item:
                    return item["value"][int(part)] if part else item["value"]
        raise NoValue(f"pixel '{name}' tells no symbol {wanted}")

    def channel(self, name, wanted):
        for told in self.explain(name)["sections"]:
            for item in told["items"]:
                if item.get("table") == "channels":
                    for row in item["rows"]:
                        if row[0] == wanted:
                            return parsed(row[1])
        raise NoValue(f"pixel '{name}' has no channel {wanted}")

    def row(self, name, wanted):
        table, _, first = wanted.partition("/")
        for told in self.explain(name)["sections"]:
            for item in told["items"]:
                if item.get("table") == table:
                    for row in item["rows"]:
                        if row[0] == first:
                            return parsed(row[1])
                    if not first:
                        return [[float(cell) for cell in row] for row in item["rows"]]
        raise NoValue(f"pixel '{name}' has no row {wanted}")

    def scene(self, name, wanted):
        found = tomllib.loads((self.root / self.table[name]["scene"]).read_text(encoding="utf-8"))
        for key in re.findall(r"\w+", wanted):
            try:
                found = found[int(key) if key.isdigit() else key]
            except (KeyError, IndexError) as absent:
                raise NoValue(f"the scene of pixel '{name}' does not say {wanted}") from absent
        return found


def from_session(markdown, wanted):
    session = "\n".join(re.findall(r"^```gdb\n(.*?)^```", markdown, re.S | re.M)).splitlines()
    if wanted.startswith("print "):
        for line, answer in zip(session, session[1:]):
            if line == f"(gdb) {wanted}" and "=" in answer:
                return parsed(answer.split("= ", 1)[1])
    for line in session:
        if line.startswith(f"{wanted} = "):
            return parsed(line.split(" = ", 1)[1])
        if line == wanted:
            return parsed(line)
    raise NoValue(f"the session of the page does not show '{wanted}'")


def from_mark(markdown, key):
    mark = re.search(rf"<!-- number: {re.escape(key)} = (\S+) -->", markdown)
    if not mark:
        raise NoValue(f"the page has no number '{key}'")
    return float(mark.group(1))


def calculated(expression, lookup):
    """`lookup(symbol)` gives the value of another symbol."""
    names = dict(NAMES)

    def insert(match):
        name = f"v{len(names)}"
        names[name] = lookup(match.group(1))
        return name
    text = re.sub(r"\{((?:[^{}]|\{[^{}]*\})+)\}", insert, expression)
    try:
        return eval(text, {"__builtins__": {}, **names})  # the repository's own file, not a visitor's
    except (TypeError, NameError, SyntaxError, ValueError, ZeroDivisionError) as error:
        raise NoValue(f"cannot work out {expression}: {error}") from error


def find(source, page, pixel, pixels, lookup):
    """(value, where it comes from in words)."""
    kind, _, wanted = source.partition(" ")
    if kind in ("explain", "channel", "row", "scene"):
        if pixel not in pixels.table:
            raise NoValue(f"there is no pixel '{pixel}'")
        read = {"explain": pixels.symbol, "channel": pixels.channel, "row": pixels.row, "scene": pixels.scene}[kind]
        entry = pixels.table[pixel]
        if kind == "scene":
            return read(pixel, wanted), f"in {entry['scene']}"
        return read(pixel, wanted), f"at pixel ({', '.join(map(str, entry['at']))}) of {entry['scene']}"
    if kind == "session":
        return from_session(page.markdown, wanted), "in the lesson's session"
    if kind == "number":
        return from_mark(page.markdown, wanted), "as worked out on this page"
    if kind == "calc":
        return calculated(wanted, lookup), "worked out by hand" if "{" not in wanted else "from the other symbols"
    raise NoValue(f"'{kind}' is no source of values")
