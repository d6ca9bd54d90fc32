"""The frame around every page: template.html, filled."""
import re
from pathlib import Path


def read():
    return (Path(__file__).resolve().parent / "template.html").read_text(encoding="utf-8")


def fill(template, values):
    """$if(x)$...$endif$ (with $else$) and $x$, as Pandoc's templates have them; values are HTML."""
    def branch(match):
        return match.group(2) if values.get(match.group(1)) else (match.group(3) or "")
    text = re.sub(r"\$if\((\w+)\)\$(.*?)(?:\$else\$(.*?))?\$endif\$\n?", branch, template, flags=re.S)
    return re.sub(r"\$(\w+)\$", lambda m: str(values.get(m.group(1), "")), text)
