#!/usr/bin/env python3
"""A page of the site from a server with the headers for threads draws the program's bits in all cores, after a crash, too;
without the headers, or without the module, it draws the same in one thread.
Usage: check_threads.py CHROMIUM KREDA HASH_SCENE_FILES FOLDER   (in the folder of the sources)"""
import shutil
import subprocess
import sys
import threading
from pathlib import Path

sys.path.insert(0, "docs/site")
import live
import serve
from browser import Browser

CHROMIUM, KREDA, HASHES, FOLDER = sys.argv[1:5]
SCENES = ["examples/25_exponents/live.toml", "examples/assignments/A7_shadow_map/scenes/soft.toml", "examples/55_views/views.toml"]


def run(*command):
    return subprocess.run(command, capture_output=True, text=True, timeout=300, check=True).stdout


def check(browser, address, scene, isolated):
    browser.open("about:blank")
    browser.open(address)
    film = browser.wait("document.documentElement.dataset.film")
    expected = run(HASHES, scene).split()[0]
    assert film == expected, f"{address}: {film} in the browser, {expected} in the program"
    threads = browser.value("kreda.engine.threads")
    cores = browser.value("navigator.hardwareConcurrency")
    assert threads == (cores if isolated else 1), f"{address}: {threads} threads; the browser has {cores} cores"
    said = browser.value("document.getElementById('numbers').textContent")
    assert said.endswith(f", {threads} threads") == (threads > 1), said
    browser.value("kreda.engine.call('threads')")
    ms = browser.value("""(async () => { const times = [];
for (let i = 0; i < 20; i += 1) times.push((await kreda.engine.call('draw', kreda.hand.pose(), 640, 360, 1, '')).ms);
return times.sort((a, b) => a - b)[10]; })()""")
    drew = browser.value("kreda.engine.call('threads').then((answer) => answer.threads)")
    assert drew == threads, f"{address}: {drew} of {threads} threads took tiles of twenty pictures"
    print(f"{scene}: {film}, {drew} of {threads} threads took tiles, {ms:.1f} ms at 640 x 360")


def main():
    folder = Path(FOLDER).resolve() / "site"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "live").mkdir(parents=True)
    assert live.copy_threads(Path.cwd(), folder / "live"), "the module with threads is not built"
    for number, scene in enumerate(SCENES):
        page = folder / "live" / f"{number}.html"
        run(KREDA, "view", scene, "-o", str(page), "--quiet")
        live.share_module(Path(), page)
        live.allow_threads(page)
    site = serve.server(folder)
    threading.Thread(target=site.serve_forever, daemon=True).start()
    browser = Browser(CHROMIUM, folder / "profile")
    try:
        for number, scene in enumerate(SCENES):
            check(browser, f"http://localhost:{site.server_port}/live/{number}.html", scene, isolated=True)
        browser.value("kreda.engine.call('no_such_work').catch(() => {})")
        assert browser.wait("document.getElementById('message').textContent.includes('was started again')"), "a crash is not told"
        film = browser.wait("kreda.engine.call('hash').then((h) => h.hash)")
        assert film == run(HASHES, SCENES[-1]).split()[0], f"after a crash: {film}"
        check(browser, (folder / "live/0.html").as_uri(), SCENES[0], isolated=False)
    finally:
        browser.close()
        site.shutdown()


main()
