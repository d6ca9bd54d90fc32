#!/usr/bin/env python3
"""Opens a page of `kreda view` in headless Firefox: the film's bits are the program's, a control changes the picture and "Undo all"
brings it back, a pixel is explained.
Usage: check_firefox.py FIREFOX KREDA HASH_SCENE_FILES FOLDER   (in the folder of the sources)"""
import shutil
import subprocess
import sys
from pathlib import Path

from firefox import Firefox

FIREFOX, KREDA, HASHES, FOLDER = sys.argv[1:5]
SCENE = "examples/25_exponents/live.toml"
AT_REST = "new Promise(r => setTimeout(r, 400)).then(() => kreda.engine.call('hash')).then(h => h.hash)"


def main():
    folder = Path(FOLDER).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    page = folder / "firefox.html"
    subprocess.run([KREDA, "view", SCENE, "-o", str(page), "--quiet"], check=True, capture_output=True)
    expected = subprocess.run([HASHES, SCENE], check=True, capture_output=True, text=True).stdout.split()[0]
    shutil.rmtree(folder / "firefox", ignore_errors=True)
    browser = Firefox(FIREFOX, folder / "firefox")
    try:
        browser.open(page.as_uri())
        film = browser.wait("document.documentElement.dataset.film", 300)
        assert film == expected, f"{film} in Firefox, {expected} in the program; the page says: " + browser.value(
            "document.getElementById('message').textContent")
        browser.value("document.getElementById('picture').dispatchEvent(new KeyboardEvent('keydown', { key: 'n', bubbles: true }))")
        assert browser.wait(f"{AT_REST}.then(h => h !== '{film}')"), "N steps no list"
        browser.value("document.getElementById('undo').click()")
        assert browser.wait(f"{AT_REST}.then(h => h === '{film}')"), "Undo all does not bring the picture back"
        browser.value("document.getElementById('picture').dispatchEvent(new KeyboardEvent('keydown', { key: 'Enter', bubbles: true }))")
        told = browser.wait("!document.getElementById('told').hidden && document.getElementById('explained').textContent")
        assert told and told.startswith("Pixel ("), f"no pixel is explained: {told}"
        print(f"{SCENE}: {film} in Firefox and in the program; controls and the explanation work")
    finally:
        browser.close()


main()
