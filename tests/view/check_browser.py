#!/usr/bin/env python3
"""Opens pages of `kreda view` in headless Chromium and compares the film's bits with the program's.
Usage: check_browser.py CHROMIUM KREDA HASH_SCENE_FILES FOLDER   (in the folder of the sources)"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

CHROMIUM, KREDA, HASHES, FOLDER = sys.argv[1:5]
SCENES = ["examples/55_views/views.toml", "examples/assignments/A7_shadow_map/scenes/soft.toml"]


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=300)


def page_after_drawing(page, profile):
    """The document once its first picture is there: the page writes its hash into <html data-film>."""
    shutil.rmtree(profile, ignore_errors=True)
    done = run(CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
               "--virtual-time-budget=60000", "--dump-dom", page.as_uri())
    return done.stdout


def main():
    folder = Path(FOLDER).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for scene in SCENES:
        page = folder / (Path(scene).stem + ".html")
        made = run(KREDA, "view", scene, "-o", str(page), "--quiet")
        assert made.returncode == 0, made.stderr
        assert made.stdout.strip() == page.as_uri(), made.stdout
        expected = run(HASHES, scene).stdout.split()[0]
        text = page_after_drawing(page, folder / "profile")
        film = re.search(r'<html[^>]*data-film="([0-9a-f]+)"', text)
        message = re.search(r'id="message"[^>]*>([^<]*)<', text)
        said = message.group(1) if message else "nothing"
        assert film, f"{scene}: the page drew nothing; it says: {said}"
        assert film.group(1) == expected, f"{scene}: {film.group(1)} in the browser, {expected} in the program"
        assert not re.search(r'(?:src|href)="(?!data:)[a-z]+:', text), "the page asks something of the network"
        print(f"{scene}: {expected} in both")


main()
