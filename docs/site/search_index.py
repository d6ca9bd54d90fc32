"""What the search box knows: pages, their headings, symbols and terms, as a script that a page opened from a file may load."""
import html
import json
import re


def words_of(body):
    body = body.replace("<wbr>", "")
    text = re.sub(r"<math.*?</math>|<pre.*?</pre>|<[^>]+>", " ", body, flags=re.S)
    return " ".join(html.unescape(text).split())


def write(file, bodies, symbols, glossary):
    entries = []
    for page, body in bodies:
        text = words_of(body)
        title = f"{page.number} {page.title}".strip()
        entries.append({"t": title, "u": page.file, "k": "page", "x": text[:4000]})
        for mark, heading in re.findall(r'<h[23] id="([^"]+)">(.*?)</h[23]>', body, re.S):
            name = re.sub(r"<[^>]+>", "", heading)
            if page.number and name in ("Goal", "The idea", "In the code", "Step through it", "Break it", "Exercises", "Sources"):
                continue
            entries.append({"t": html.unescape(name), "u": f"{page.file}#{mark}", "k": title, "x": ""})
    entries += symbols.search_entries() + glossary.search_entries()
    file.write_text("window.kredaIndex = " + json.dumps(entries, ensure_ascii=False, separators=(",", ":")) + ";\n",
                    encoding="utf-8")
