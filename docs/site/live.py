"""Live figures: a lesson whose folder has a live.toml gets that scene as a page of `kreda view`, loaded when it is seen."""
import html
import re
import shutil
import subprocess
from concurrent.futures import ThreadPoolExecutor


def scenes(root):
    """{number of the lesson: file}. The first line of a file says which controls stand first: "# live: fog.density"."""
    return {path.parent.name[:2]: path for path in sorted(root.glob("examples/[0-9][0-9]_*/live.toml"))}


def controls(scene):
    first = scene.read_text(encoding="utf-8").split("\n", 1)[0]
    said = re.fullmatch(r"# live: (.+)", first)
    if not said:
        raise SystemExit(f"docs: {scene} must begin with '# live: KEY KEY ...', the controls that stand first")
    return said.group(1).split()


MODULE = re.compile(r'(<script type="text/plain" id="wasm">)(.*?)(</script>)', re.S)


def share_module(root, page):
    """Take the module out of a page: live/module.js, which all of them load, in the form that takes more bytes and starts at once.
    It hands over a text, for a page from a disk may load scripts and nothing else."""
    text = page.read_text(encoding="utf-8")
    quick = root / "build/web/share/kreda/view_module.txt"
    module = quick.read_text(encoding="ascii") if quick.exists() else MODULE.search(text).group(2)
    (page.parent / "module.js").write_text(f'document.getElementById("wasm").textContent = "{module}";\n', encoding="utf-8")
    text = MODULE.sub(r'\1\3\n<script src="module.js"></script>', text)
    page.write_text(text.replace("script-src 'unsafe-inline'", "script-src 'self' file: 'unsafe-inline'", 1), encoding="utf-8")


def copy_threads(root, folder):
    """The module with threads beside the pages, where it was built (./course docs --serve); whether it was."""
    built = root / "build/web-threads/bin"
    if not (built / "kreda_web.worker.js").exists():
        return False
    (folder / "threads").mkdir(exist_ok=True)
    for name in ("kreda_web.js", "kreda_web.wasm", "kreda_web.worker.js"):
        shutil.copy2(built / name, folder / "threads" / name)
    return True


def allow_threads(page):
    """Let the page load that module from its server: docs/site/serve.py."""
    text = page.read_text(encoding="utf-8").replace('<html lang="en">', '<html lang="en" data-threads="threads/">', 1)
    page.write_text(text.replace("worker-src blob:", "worker-src blob: 'self'; connect-src 'self'", 1), encoding="utf-8")


def put_poster(page):
    """The picture over the canvas, until the module has drawn."""
    text = page.read_text(encoding="utf-8").replace('<svg id="overlay"', f'<img id="poster" src="{page.stem}.png" alt="">\n      <svg id="overlay"', 1)
    page.write_text(text.replace("img-src data:", "img-src 'self' file: data:", 1), encoding="utf-8")


def write(root, folder, kreda):
    """Pages live/NN.html and the picture of each, which stands there until the module has drawn; {number: page}. None where kreda
    has no page to put a scene in: the pictures stay."""
    def one(item):
        number, scene = item
        page = folder / "live" / f"{number}.html"
        chosen = [word for key in controls(scene) for word in ("--control", key)]
        done = subprocess.run([kreda, "view", scene, "-o", page, "--quiet", *chosen], capture_output=True, text=True)
        if done.returncode != 0 and "course view" not in done.stderr:
            raise SystemExit(f"docs: {scene}: {done.stderr.strip()}")
        if done.returncode == 0:
            subprocess.run([kreda, "render", scene, "-o", page.with_suffix(".png"), "--quiet"], check=True, capture_output=True)
        return number, f"live/{number}.html" if done.returncode == 0 else None
    (folder / "live").mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(2) as pool:
        made = dict(pool.map(one, scenes(root).items()))
    if made and not any(made.values()):
        print("note: ./course view builds what live figures need; this site has pictures alone")
    has_threads = copy_threads(root, folder / "live")
    for page in filter(None, made.values()):
        share_module(root, folder / page)
        if has_threads:
            allow_threads(folder / page)
        put_poster(folder / page)
    return {number: page for number, page in made.items() if page}


def figure(page, title):
    """In a fold; site.js opens it and loads the page when it is scrolled into view. Without a script the link works."""
    name = html.escape(title)
    return (f'<details class="live"><summary>Live: turn the numbers, walk around</summary>'
            f'<iframe data-src="{page}" title="{name}, live"></iframe>'
            f'<p><a href="{page}">In a page of its own</a>, drawn by the same code as WebAssembly.</p></details>')


def put(body, page, title):
    """Behind the first picture, else at the end."""
    live = figure(page, title)
    at = body.find("</figure>")
    return body + live if at < 0 else body[:at + 9] + live + body[at + 9:]
