#!/usr/bin/env python3
"""Opens pages of `kreda view` in headless Chromium: the film's bits are the program's, keys and controls change the picture,
R and "Undo all" bring it back to the bit, fingers turn and come nearer, a pixel is explained, a broken file is one line, crashes are
survived. A change reads no file again, a dropped .hdr takes the place of a named sky, a .glb is read, and a .gltf with its files as they are, in a folder or a .zip, a hidden page draws nothing and forgets nothing,
a window of another size is still met by clicks, the module is unpacked once, a lesson's page loads its figure when it is seen, and the figure is its picture until the module has drawn.
Usage: check_browser.py CHROMIUM KREDA HASH_SCENE_FILES FOLDER   (in the folder of the sources)"""
import base64
import json
import re
import shutil
import struct
import subprocess
import sys
import zipfile
import zlib
from pathlib import Path

from browser import Browser

sys.path.append("docs/site")
import live

CHROMIUM, KREDA, HASHES, FOLDER = sys.argv[1:5]
SCENES = ["examples/25_exponents/live.toml", "examples/assignments/A7_shadow_map/scenes/soft.toml"]
AT_REST = "new Promise(r => setTimeout(r, 400)).then(() => kreda.engine.call('hash')).then(h => h.hash)"
DROP = """(() => { const data = new DataTransfer();
for (const [name, bytes] of Object.entries(FILES)) data.items.add(new File([Uint8Array.from(atob(bytes), (c) => c.charCodeAt(0))], name));
document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true })); })()"""
MESH = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n"
MESH_SCENE = """[image]
size = [64, 36]
background = "environment"
[camera]
position = [0, 0, 3]
[environment]
sky = "studio"
[[light]]
direction = [0, 0, -1]
[[material]]
name = "red"
diffuse = [0.7, 0.1, 0.1]
[[object]]
mesh = "a.obj"
material = "red"
"""
GLTF_SCENE = MESH_SCENE.replace('"a.obj"\nmaterial = "red"', '"b.glb"')  # in the file's own material
# Radiance's format without packing: every texel is half as bright in red as in green, and a quarter of that in blue.
SKY = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 32 +X 64\n" + bytes([64, 128, 32, 128]) * (64 * 32)


def binary_gltf():
    """A triangle with a colour of its own: the 12 bytes of the head, the JSON, and three corners, each part padded to four bytes."""
    corners = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0)
    told = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0, "rotation": [0, 0.38268343, 0, 0.9238795]}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "material": 0}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [0.1, 0.6, 0.2, 1], "metallicFactor": 0.5, "roughnessFactor": 0.4}}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": len(corners)}], "buffers": [{"byteLength": len(corners)}]}
    text = json.dumps(told).encode()
    text += b" " * (-len(text) % 4)
    parts = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(corners), b"BIN\0") + corners
    return struct.pack("<4sII", b"glTF", 2, 12 + len(parts)) + parts


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=300)


def make_page(scene, folder):
    page = folder / (Path(scene).parent.name + ".html")
    made = run(KREDA, "view", scene, "-o", str(page), "--quiet")
    assert made.returncode == 0, made.stderr
    assert made.stdout.strip() == page.as_uri(), made.stdout
    asked = re.findall(r"""(?:src|href)=["'](?!data:)[a-z]+:[^"']*""", page.read_text(encoding="utf-8"))
    assert not asked, f"the page asks something of the network: {asked}"
    return page


def key(browser, name):
    for kind in ("keydown", "keyup"):
        browser.value(f"document.getElementById('picture').dispatchEvent(new KeyboardEvent('{kind}', {{ key: '{name}', bubbles: true }}))")


def drop(browser, **files):
    """Drop these files, a_toml=... as a.toml, on the page."""
    packed = {name.replace("_", "."): base64.b64encode(data if isinstance(data, bytes) else data.encode()).decode() for name, data in files.items()}
    browser.value(DROP.replace("FILES", json.dumps(packed)))


def message(browser):
    return browser.value("document.getElementById('message').textContent")


def check_film(browser, scene, folder):
    browser.open(make_page(scene, folder).as_uri())
    film = browser.wait("document.documentElement.dataset.film")
    assert film, f"{scene}: the page drew nothing; it says: {message(browser)}"
    expected = run(HASHES, scene).stdout.split()[0]
    assert film == expected, f"{scene}: {film} in the browser, {expected} in the program"
    print(f"{scene}: {expected} in both")
    return film


def check_use(browser, film):
    browser.value("kreda.hand.turn(0.3, 0.1); kreda.page.dirty = true")
    assert browser.value(AT_REST) != film, "the camera turned and the picture stayed"
    key(browser, "r")
    assert browser.wait(f"{AT_REST}.then(h => h === '{film}')", 20), "R does not bring the picture back to the bit"
    key(browser, "n")
    assert browser.wait(f"{AT_REST}.then(h => h !== '{film}')", 20), "N steps no list"
    browser.value("document.getElementById('undo').click()")
    assert browser.wait(f"{AT_REST}.then(h => h === '{film}')", 20), "Undo all does not bring the picture back"
    key(browser, "Enter")
    told = browser.wait("!document.getElementById('told').hidden && document.getElementById('explained').textContent")
    assert told and told.startswith("Pixel ("), f"no pixel is explained: {told}"
    assert browser.value("document.getElementById('overlay').textContent") == "nvlhr"
    drop(browser, bad_toml="[camera]\nnaer = 1\n")
    assert browser.wait("document.getElementById('message').textContent.startsWith('bad.toml:2:1: unknown key')"), message(browser)
    for _ in range(2):
        browser.value("document.getElementById('message').textContent = ''; kreda.engine.call('no_such_work').catch(() => {})")
        assert browser.wait("document.getElementById('message').textContent.includes('was started again')"), message(browser)
        assert browser.wait(f"{AT_REST}.then(h => h === '{film}')", 20), "after a crash the picture is another"
    print("camera, keys, explain, a broken file and crashes: as they should be")


def turn_control(browser, path, number):
    """As who types a number into the control of this key."""
    browser.value(f"""(() => {{ const field = document.querySelector('[data-path="{path}"] input[type=number]');
field.value = {number}; field.dispatchEvent(new Event("change", {{ bubbles: true }})); }})()""")


def check_files(browser):
    """Dropped files: a mesh is not read again when a key changes, an image takes the place of a sky that has a name."""
    drop(browser, a_toml=MESH_SCENE, a_obj=MESH)
    assert browser.wait("kreda.page.path === 'a.toml' && kreda.page.scene"), message(browser)
    film = browser.value(AT_REST)
    turn_control(browser, "material.0.shininess", 3)  # a file that is some milliseconds old is read once more
    browser.value(AT_REST)
    reads = browser.value("kreda.engine.call('reads').then((r) => r.reads)")
    turn_control(browser, "light.0.intensity", 0.25)
    assert browser.wait(f"{AT_REST}.then(h => h !== '{film}')", 20), "a control was turned and the picture stayed"
    assert browser.value("kreda.engine.call('reads').then((r) => r.reads)") == reads, "a key changed, and the mesh was read again"
    film = browser.value(AT_REST)
    drop(browser, a_obj=MESH.replace("v 0 1 0", "v 0 0 0"), a_toml=MESH_SCENE)
    assert browser.wait(f"{AT_REST}.then(h => h !== '{film}')", 20), "another mesh of the same name was dropped, and the old one stayed"
    film = browser.value(AT_REST)
    drop(browser, sky_hdr=SKY)
    assert browser.wait("kreda.page.scene.tables.environment.file === 'sky.hdr'"), message(browser)
    assert browser.value("kreda.page.scene.tables.environment.sky") is None, "the sky stayed beside the file"
    assert browser.value(AT_REST) != film, "the environment was changed and the picture stayed"
    corner = browser.value("[...document.getElementById('picture').getContext('2d').getImageData(0, 0, 1, 1).data]")
    assert corner[1] > corner[0] > corner[2], f"the background is not the sky that was dropped: {corner}"
    print("files: the mesh is kept, a .hdr takes the place of a named sky")


def check_gltf(browser, folder):
    """A .glb in a scene has the program's bits; alone it is opened, too; a broken one is one line."""
    (folder / "b.glb").write_bytes(binary_gltf())
    (folder / "b.toml").write_text(GLTF_SCENE, encoding="utf-8")
    expected = run(HASHES, str(folder / "b.toml")).stdout.split()[0]
    drop(browser, b_toml=GLTF_SCENE, b_glb=binary_gltf())
    assert browser.wait("kreda.page.path === 'b.toml' && kreda.page.scene"), message(browser)
    assert browser.wait(f"{AT_REST}.then(h => h === '{expected}')", 20), f"a .glb: {browser.value(AT_REST)}, in the program {expected}; {message(browser)}"
    drop(browser, b_glb=binary_gltf())
    assert browser.wait("kreda.page.path === 'b.glb' && kreda.page.scene"), message(browser)
    drop(browser, c_glb=binary_gltf()[:300])
    assert browser.wait("document.getElementById('message').textContent.startsWith('c.glb')"), message(browser)
    print("glTF: a .glb has the program's bits, alone and in a scene; a broken one is one line")


def png_of_two_colours():
    """Two texels side by side, 8-bit RGB."""
    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    head = struct.pack(">IIBBBBB", 2, 1, 8, 2, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(bytes([0, 255, 40, 30, 200, 60, 250]))) + chunk(b"IEND", b"")


def gltf_of_three_files():
    """{path: bytes} as programs write it: JSON that names a buffer beside it and a texture in a folder below."""
    corners = struct.pack("<9f", -1, -1, 0, 1, -1, 0, 0, 1, 0) + struct.pack("<6f", 0, 0, 1, 0, 0.5, 1)
    told = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0, "TEXCOORD_0": 1}, "material": 0}]}],
            "materials": [{"pbrMetallicRoughness": {"baseColorTexture": {"index": 0}, "metallicFactor": 0}}],
            "textures": [{"source": 0}], "images": [{"uri": "textures/two%20colours.png"}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [-1, -1, 0], "max": [1, 1, 0]},
                          {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 24}],
            "buffers": [{"byteLength": len(corners), "uri": "scene.bin"}]}
    return {"scene.gltf": json.dumps(told).encode(), "scene.bin": corners, "textures/two colours.png": png_of_two_colours(),
            "shown.toml": MESH_SCENE.replace('"a.obj"\nmaterial = "red"', '"scene.gltf"').encode()}


def drop_paths(browser, *paths):
    """As the system's file manager does it."""
    data = {"items": [], "files": [str(path) for path in paths], "dragOperationsMask": 1}
    for kind in ("dragEnter", "dragOver", "drop"):
        browser.ask("Input.dispatchDragEvent", browser.session, type=kind, x=100, y=100, data=data)


def check_many_files(browser, folder):
    """A .gltf of several files has the program's bits as files side by side, as a folder and as a .zip; half an archive is one line."""
    model = folder / "model"
    files = gltf_of_three_files()
    with zipfile.ZipFile(folder / "packed.zip", "w", zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            (model / path).parent.mkdir(parents=True, exist_ok=True)
            (model / path).write_bytes(data)
            archive.writestr(f"packed/{path}", data, zipfile.ZIP_STORED if path.endswith(".png") else None)
    expected = run(HASHES, str(model / "shown.toml")).stdout.split()[0]
    for told, dropped, opened in (("a folder", [model], "model/shown.toml"), ("a .zip", [folder / "packed.zip"], "packed/shown.toml"),
                                  ("files", [model / path for path in files], "shown.toml")):
        drop_paths(browser, *dropped)
        assert browser.wait(f"kreda.page.path === '{opened}' && kreda.page.scene"), f"{told}: {message(browser)}"
        assert browser.wait(f"{AT_REST}.then(h => h === '{expected}')", 20), f"{told}: {browser.value(AT_REST)}, in the program {expected}; {message(browser)}"
    (folder / "half.zip").write_bytes((folder / "packed.zip").read_bytes()[:400])
    drop_paths(browser, folder / "half.zip")
    assert browser.wait("document.getElementById('message').textContent.startsWith('half.zip: cannot be unpacked')"), message(browser)
    print("glTF of several files: side by side, as a folder and as a .zip, with the program's bits")


def press(browser, name, code, text=""):
    """A key as the browser has it from the keyboard."""
    at = {"key": text or name, "code": name, "windowsVirtualKeyCode": code}
    browser.ask("Input.dispatchKeyEvent", browser.session, type="keyDown" if text else "rawKeyDown", text=text, **at)
    browser.ask("Input.dispatchKeyEvent", browser.session, type="keyUp", **at)


def check_keyboard(browser):
    """Tab reaches everything that can be clicked or typed into, also with all folds open; Space, Enter and arrows work it."""
    browser.value("""document.querySelectorAll('details').forEach((fold) => { fold.open = true; });
globalThis.stops = [...document.querySelectorAll('a[href], button, input, select, summary, [tabindex]')].filter((e) => e.checkVisibility() && !e.disabled);
stops[0].focus(); globalThis.met = new Set([stops[0]])""")
    count = browser.value("stops.length")
    for _ in range(count + 3):
        press(browser, "Tab", 9)
        browser.value("met.add(document.activeElement)")
    missed = browser.value("stops.filter((e) => !met.has(e)).map((e) => e.outerHTML.slice(0, 90))")
    assert count > 50 and not missed, f"of {count} controls Tab misses {missed}"
    browser.value("document.getElementById('turn').focus()")
    for wanted in ("true", "false"):
        press(browser, "Space", 32, " ")
        assert browser.wait(f"document.getElementById('turn').ariaPressed === '{wanted}'", 5), "Space does not press a button"
    film = browser.value(AT_REST)
    browser.value("""document.querySelector('[data-path="material.0.shininess"] input[type=range]').focus()""")
    press(browser, "ArrowLeft", 37)
    assert browser.wait(f"{AT_REST}.then(h => h !== '{film}')", 20), "an arrow key does not move a slider"
    browser.value("document.getElementById('view').focus()")
    press(browser, "ArrowDown", 40)
    assert browser.wait("document.getElementById('view').value !== ''", 5), "an arrow key chooses no view"
    browser.value("document.getElementById('undo').focus()")
    press(browser, "Enter", 13, "\r")
    browser.value("document.getElementById('view').value = ''; document.getElementById('view').onchange()")
    assert browser.wait("![...kreda.page.changes.keys()].length", 20), "Enter does not press a button"
    print(f"keyboard: Tab reaches all {count} controls; Space, Enter and arrows work them")


def check_hidden(browser):
    """Another tab in front: nothing is drawn, and what changed meanwhile is there afterwards."""
    film = browser.value(AT_REST)
    shown = browser.ask("Target.getTargetInfo", browser.session)["targetInfo"]["targetId"]
    other = browser.ask("Target.createTarget", url="about:blank")["targetId"]
    browser.ask("Target.activateTarget", targetId=other)
    is_hidden = browser.wait("document.hidden", 10)
    if is_hidden:
        browser.value("document.getElementById('turn').click()")
        before = browser.value("new Promise((r) => setTimeout(r, 300)).then(() => kreda.page.drawn)")
        after = browser.value("new Promise((r) => setTimeout(r, 1000)).then(() => kreda.page.drawn)")
        assert before == after, f"{after - before} pictures in a page that nobody sees"
        browser.value("document.getElementById('turn').click()")
        turn_control(browser, "light.0.intensity", 0.7)
    browser.ask("Target.activateTarget", targetId=shown)
    browser.ask("Target.closeTarget", targetId=other)
    assert browser.wait("!document.hidden", 10)
    if is_hidden:
        assert browser.wait(f"{AT_REST}.then(h => h !== '{film}')", 20), "a change from while the page was hidden is lost"
    print("a hidden page draws nothing and forgets nothing" if is_hidden else "this Chromium hides no page: not checked")


def check_sizes(browser):
    """At each width the picture fits and a click in its middle explains the pixel in its middle."""
    for width, height in ((1280, 900), (820, 500), (390, 800)):
        browser.ask("Emulation.setDeviceMetricsOverride", browser.session, width=width, height=height, deviceScaleFactor=1, mobile=False)
        browser.value("scrollTo(0, 0); document.getElementById('told').hidden = true")
        box = browser.value("(({ x, y, width, height }) => [x, y, width, height])(document.getElementById('picture').getBoundingClientRect())")
        assert box[0] >= 0 and box[0] + box[2] <= width and box[1] + box[3] <= height, f"{width} x {height}: the picture is at {box}"
        at = {"x": box[0] + box[2] / 2, "y": box[1] + box[3] / 2, "button": "left", "clickCount": 1}
        for kind in ("mousePressed", "mouseReleased"):
            browser.ask("Input.dispatchMouseEvent", browser.session, type=kind, **at)
        told = browser.wait("!document.getElementById('told').hidden && document.getElementById('explained').textContent")
        middle = browser.value("[canvas => canvas.width / 2, canvas => canvas.height / 2].map((f) => f(document.getElementById('picture')))")
        pixel = [int(number) for number in re.match(r"Pixel \((\d+), (\d+)\)", told or "Pixel (-9, -9)").groups()]
        assert all(abs(a - b) <= 1 for a, b in zip(pixel, middle)), f"{width} x {height}: a click at {middle} explains {pixel}"
    print("sizes: 1280, 820 and 390 pixels wide, clicks meet their pixels")


def check_lesson(browser, folder, page):
    """The site's own script: a live figure far below is loaded when it is scrolled to."""
    shutil.copy("docs/site/site.js", folder / "site.js")
    text = f"""<!DOCTYPE html><title>A lesson</title><p style="height: 5000px">text</p>
<details class="live"><summary>Live</summary><iframe data-src="{page.name}" style="width: 100%; height: 700px"></iframe></details>
<script src="site.js"></script>"""
    (folder / "lesson.html").write_text(text, encoding="utf-8")
    browser.open((folder / "lesson.html").as_uri())
    assert browser.wait("document.querySelector('details')?.open"), "the figure does not stand open"
    assert browser.value("new Promise((r) => setTimeout(r, 500)).then(() => document.querySelector('iframe').src)") == "", "loaded before it is seen"
    browser.value("document.querySelector('details').scrollIntoView()")
    assert browser.wait(f"document.querySelector('iframe').src.endsWith('{page.name}')", 20), "scrolled to, and not loaded"
    print("a lesson's figure is loaded when it is seen")


def check_kept(browser, page, film):
    """The first page that a browser opens unpacks the module, in a worker; another finds it unpacked."""
    browser.ask("Page.enable", browser.session)
    count = "workers = 0; Worker = class extends Worker { constructor(...given) { super(...given); workers += 1; } };"
    script = browser.ask("Page.addScriptToEvaluateOnNewDocument", browser.session, source=count)["identifier"]
    for name, workers in [("a.html", 1), ("b.html", 1), ("c.html", 2)]:
        another = shutil.copy(page, page.parent / name)
        if name == "c.html":
            browser.value("new Promise((done) => { indexedDB.deleteDatabase('kreda').onsuccess = done; })")
        browser.open(another.as_uri())
        assert browser.wait(f"document.documentElement.dataset.film === '{film}'", 60), f"{name} drew nothing; it says: {message(browser)}"
        assert browser.value("workers") == workers, f"{name} made {browser.value('workers')} workers, not {workers}"
    browser.ask("Page.removeScriptToEvaluateOnNewDocument", browser.session, identifier=script)
    print("the module is unpacked once, and kept for the next page")


def check_site(browser, folder, page, film):
    """A live figure of the site: the picture that the program drew stands there until the module has drawn, and stays where it cannot."""
    live_page = folder / "live" / "25.html"
    live_page.parent.mkdir(exist_ok=True)
    shutil.copy(page, live_page)
    run(KREDA, "render", SCENES[0], "-o", str(live_page.with_suffix(".png")), "--quiet")
    live.share_module(Path(), live_page)
    live.put_poster(live_page)
    module = live_page.parent / "module.js"
    module.rename(folder / "module.js")
    browser.open(live_page.as_uri())
    assert browser.wait("document.getElementById('message')?.textContent.includes('module of this page is missing')"), f"without its module the page says: {message(browser)}"
    assert browser.wait("document.getElementById('poster')?.naturalWidth > 0", 10), "without its module the figure is blank"
    (folder / "module.js").rename(module)
    browser.open(live_page.as_uri() + "?again")
    assert browser.wait(f"document.documentElement.dataset.film === '{film}'"), f"the site's page drew nothing; it says: {message(browser)}"
    assert browser.wait("!document.getElementById('poster')", 10), "the picture stands before what the module draws"
    print("the site's figure shows its picture until the module has drawn")


def touch(browser, kind, *points):
    browser.ask("Input.dispatchTouchEvent", browser.session, type=kind, touchPoints=[{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(points)])


def check_touch(browser, film):
    """One finger goes round, two fingers that part come nearer; without a finger nothing moves, and R goes back."""
    browser.ask("Emulation.setDeviceMetricsOverride", browser.session, width=390, height=800, deviceScaleFactor=1, mobile=True)
    browser.ask("Emulation.setTouchEmulationEnabled", browser.session, enabled=True, maxTouchPoints=2)
    assert browser.value("document.documentElement.scrollWidth") <= 390, "the page is wider than a telephone"
    box = browser.value("(({ x, y, width, height }) => [x, y, width, height])(document.getElementById('picture').getBoundingClientRect())")
    x, y = box[0] + box[2] / 2, box[1] + box[3] / 2
    distance = "Math.hypot(...kreda.hand.position.map((p, i) => p - kreda.hand.target[i]))"
    before = browser.value(distance)
    touch(browser, "touchStart", (x, y))
    touch(browser, "touchMove", (x + 60, y + 10))
    touch(browser, "touchEnd")
    assert browser.value(AT_REST) != film, "a finger was drawn over the picture, and it stayed"
    assert abs(browser.value(distance) - before) < 1e-6 * before, "one finger changed the distance"
    touch(browser, "touchStart", (x - 20, y), (x + 20, y))
    touch(browser, "touchMove", (x - 60, y), (x + 60, y))
    touch(browser, "touchEnd")
    assert browser.value(distance) < 0.7 * before, f"two fingers parted: {browser.value(distance)}, {before} before"
    key(browser, "r")
    assert browser.wait(f"{AT_REST}.then(h => h === '{film}')", 20), "R does not bring the picture back after touches"
    print("touch: one finger and two, at 390 pixels")


def main():
    folder = Path(FOLDER).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    shutil.rmtree(folder / "profile", ignore_errors=True)
    browser = Browser(CHROMIUM, folder / "profile")
    try:
        films = [check_film(browser, scene, folder) for scene in reversed(SCENES)]
        check_use(browser, films[-1])
        check_keyboard(browser)
        check_touch(browser, films[-1])
        browser.ask("Emulation.setTouchEmulationEnabled", browser.session, enabled=False)
        check_sizes(browser)
        check_files(browser)
        check_gltf(browser, folder)
        check_many_files(browser, folder)
        check_hidden(browser)
        check_kept(browser, folder / "25_exponents.html", films[-1])
        check_site(browser, folder, folder / "25_exponents.html", films[-1])
        check_lesson(browser, folder, folder / "25_exponents.html")
    finally:
        browser.close()


main()
