#!/usr/bin/env python3
"""Opens pages of `kreda view` in headless Chromium: the film's bits are the program's, keys and controls change the picture,
R and "Undo all" bring it back to the bit, fingers turn and come nearer, a pixel is explained, a broken file is one line, a crash is
survived.
Usage: check_browser.py CHROMIUM KREDA HASH_SCENE_FILES FOLDER   (in the folder of the sources)"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

from browser import Browser

CHROMIUM, KREDA, HASHES, FOLDER = sys.argv[1:5]
SCENES = ["examples/25_exponents/live.toml", "examples/assignments/A7_shadow_map/scenes/soft.toml"]
AT_REST = "new Promise(r => setTimeout(r, 400)).then(() => kreda.engine.call('hash')).then(h => h.hash)"
DROP = """(() => { const data = new DataTransfer(); data.items.add(new File(["[camera]\\nnaer = 1\\n"], "bad.toml"));
document.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true })); })()"""


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
    browser.value(DROP)
    assert browser.wait("document.getElementById('message').textContent.startsWith('bad.toml:2:1: unknown key')"), message(browser)
    browser.value("kreda.engine.call('no_such_work').catch(() => {})")
    assert browser.wait("document.getElementById('message').textContent.includes('was started again')"), message(browser)
    assert browser.wait(f"{AT_REST}.then(h => h === '{film}')", 20), "after a crash the picture is another"
    print("camera, keys, explain, a broken file and a crash: as they should be")


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
        check_touch(browser, films[-1])
    finally:
        browser.close()


main()
