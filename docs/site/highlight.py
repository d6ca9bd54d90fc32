"""Code in colours with Pygments (Debian: python3-pygments), plain where it is not installed. Pandoc's own highlighter takes twelve times as long."""
import html
import re

try:
    import pygments.lexers
    from pygments.token import Comment, Keyword, Name, Number, String
except ImportError:
    pygments = None

# The classes of style.css, the special kinds before those that hold them.
CLASSES = ([(Comment.Preproc, "pp"), (Comment.PreprocFile, "im"), (Comment, "co"), (Keyword.Type, "dt"), (Keyword, "kw"),
            (Name.Builtin, "bu"), (Name.Tag, "kw"), (Name.Attribute, "dt"), (Number.Float, "fl"), (Number, "dv"), (String.Char, "ch"), (String, "st")]
           if pygments else [])


def class_of(kind):
    return next((name for known, name in CLASSES if kind in known), "")


def lines(code, language):
    """The HTML of each line of the code."""
    try:
        lexer = pygments.lexers.get_lexer_by_name(language, ensurenl=False, stripnl=False) if pygments and language else None
    except pygments.util.ClassNotFound:
        lexer = None
    if lexer is None:
        return html.escape(code, quote=False).split("\n")
    found = [""]
    for kind, text in lexer.get_tokens(code):
        name = class_of(kind)
        for n, part in enumerate(text.split("\n")):
            if n:
                found.append("")
            words = html.escape(part, quote=False)
            found[-1] += f'<span class="{name}">{words}</span>' if name and part.strip() else words
    return found


def block(match):
    """`<pre class="sh"><code>...` of a page, as Pandoc leaves it without a highlighter."""
    language, code = match.group(1), html.unescape(match.group(2))
    return f'<pre class="{language}"><code>' + "\n".join(lines(code, language)) + "</code></pre>"


def blocks(body):
    return re.sub(r'<pre class="(\w+)"><code>(.*?)</code></pre>', block, body, flags=re.S)


def numbered(code, language):
    """A whole file; line N has the id L-N."""
    marked = (f'<span id="L-{n}"><a href="#L-{n}" tabindex="-1" aria-label="line {n}"></a>{line}</span>'
              for n, line in enumerate(lines(code.rstrip(), language), 1))
    return '<div class="sourceCode"><pre class="numberSource"><code>' + "\n".join(marked) + "</code></pre></div>"
