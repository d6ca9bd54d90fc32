"""Pages on which a formula is changed: a lesson whose folder has a live.cpp gets one. The compiler is no part of the repository:
./course compiler puts its parts into out/compiler, and they are copied from there."""
import base64
import html
import json
import re
import shutil

PARTS = {"compile": ("archive", "wasi", "commands", "compile_worker"), "run": ("wasi", "run_worker"),
         "grade": ("archive", "grade_worker"), "main": ("archive", "helpers", "editor", "main")}


def starts(root):
    """{number of the lesson: file}. The first line of a file says which functions it shows: "// live: A3 phong"."""
    return {path.parent.name[:2]: path for path in sorted(root.glob("examples/[0-9][0-9]_*/live.cpp"))}


def script(folder, names):
    """Modules as one script: lines that import are left out, and so is the word export."""
    text = "\n".join((folder / f"{name}.js").read_text(encoding="utf-8") for name in names)
    return re.sub(r"^export ", "", re.sub(r"^import .*\n", "", text, flags=re.M), flags=re.M)


def lesson(root, number, path, title):
    head, text = path.read_text(encoding="utf-8").split("\n", 1)
    said = re.fullmatch(r"// live: (A\d) (\w+(?: \w+)*)", head)
    if not said:
        raise SystemExit(f"docs: {path} must begin with '// live: A3 FUNCTION FUNCTION ...', the functions that it shows")
    assignment = next(root.glob(f"examples/assignments/{said.group(1)}_*"))
    golden = {picture.stem: base64.b64encode(picture.read_bytes()).decode() for picture in sorted(assignment.glob("golden/*.png"))}
    return {"number": number, "title": title, "assignment": said.group(1), "stages": said.group(2).split(), "start": text,
            "student": (assignment / "student.cpp").read_text(encoding="utf-8"), "golden": golden, "folder": "../compiler"}


def page(root, given):
    folder = root / "tools/view/edit"
    text = (folder / "edit.html").read_text(encoding="utf-8")
    values = {"TITLE": html.escape(f"{given['number']} {given['title']}"), "LESSON": json.dumps(given).replace("<", "\\u003c"),
              "STYLE": (folder / "edit.css").read_text(encoding="utf-8"),
              **{name.upper(): script(folder, parts) for name, parts in PARTS.items()}}
    return re.sub(r"/\*([A-Z]+)\*/", lambda match: values[match.group(1)], text)


def write(root, folder, titles):
    """Pages edit/NN.html and what they load; {number: page}."""
    made = {}
    for number, path in starts(root).items():
        to = folder / "edit" / f"{number}.html"
        to.parent.mkdir(parents=True, exist_ok=True)
        to.write_text(page(root, lesson(root, number, path, titles[number])), encoding="utf-8")
        made[number] = f"edit/{number}.html"
    compiler = root / "out/compiler"
    if compiler.is_dir():
        shutil.copytree(compiler, folder / "compiler", dirs_exist_ok=True, ignore=shutil.ignore_patterns("package*"))
    elif made:
        print("note: ./course compiler fetches what the pages need on which formulas are changed; they say so")
    return made


def put(body, address, title):
    """A link at the end of the section on the code, else at the end."""
    text = (f'<p class="edit"><a href="{address}">Change the formula</a> of this page: it is compiled in the browser, '
            "drawn, and held against Kreda's.</p>")
    at = re.search(r'<h2[^>]*id="in-the-code".*?(?=<h2|$)', body, flags=re.S)
    return body[:at.end()] + text + body[at.end():] if at else body + text
