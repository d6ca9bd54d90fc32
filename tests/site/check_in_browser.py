#!/usr/bin/env python3
"""A built site in a headless Chromium, 360 and 1280 pixels wide. Usage: check_in_browser.py CHROMIUM SITE [--axe FILE] [PAGE...]
No error on the console, no picture missing, nothing wider than the window; with axe-core's axe.min.js also its rules, and the contrast in the dark.
One line a fault; exit code 1 if there are any."""
import argparse
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "view"))
from browser import Browser

WIDTHS = (360, 1280)
LOADED = "document.readyState === 'complete' && location.href !== 'about:blank'"
# Pictures wait until they are seen; here all are asked for.
PICTURES = """(async () => { const all = [...document.images]; for (const image of all) image.loading = 'eager';
await Promise.all(all.map((image) => image.complete ? 0 : new Promise((done) => { image.onload = image.onerror = done; })));
return all.filter((image) => image.naturalWidth === 0).map((image) => image.getAttribute('src')); })()"""
WIDE = """(() => { const root = document.documentElement; if (root.scrollWidth <= innerWidth) return null;
const wide = [...document.querySelectorAll('body *')].filter((e) => e.getBoundingClientRect().right > innerWidth + 1
  && !e.closest('.wide, pre, .equation, .sourceCode'));
return root.scrollWidth + ' pixels: ' + wide.slice(0, 2).map((e) => e.tagName + ' ' + e.textContent.slice(0, 40)).join(', '); })()"""
# Links within a formula are found by axe inside of the element <math>, which it takes for a picture; the keyboard reaches the same places in the list below.
RULES = "{preload: false, runOnly: ['wcag2a', 'wcag2aa', 'wcag21aa', 'best-practice'], rules: {'nested-interactive': {enabled: false}}}"
CONTRAST = "{preload: false, runOnly: {type: 'rule', values: ['color-contrast']}}"
AXE = """axe.run(document, %s).then((told) => told.violations.map((v) =>
v.id + ' x' + v.nodes.length + ': ' + v.nodes[0].html.slice(0, 120)))"""


class Listener(Browser):
    """Keeps what the page complains of."""

    def __init__(self, chromium, profile):
        self.complaints = []
        super().__init__(chromium, profile)
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable", self.session)

    def hear(self):
        message = super().hear()
        told = message.get("params", {})
        if message.get("method") == "Runtime.exceptionThrown":
            self.complaints.append(told["exceptionDetails"]["text"])
        elif message.get("method") == "Runtime.consoleAPICalled" and told["type"] in ("error", "assert"):
            self.complaints.append(str([a.get("value") for a in told["args"]]))
        elif message.get("method") == "Log.entryAdded" and told["entry"]["level"] == "error":
            self.complaints.append(told["entry"]["text"] + " " + told["entry"].get("url", ""))
        elif message.get("method") == "Network.loadingFailed" and not told.get("canceled"):
            self.complaints.append(f"{told['type']}: {told['errorText']}")
        return message

    def media(self, scheme):
        self.ask("Emulation.setEmulatedMedia", self.session, features=[{"name": "prefers-color-scheme", "value": scheme}])


def faults_of(browser, page, axe):
    browser.complaints.clear()
    browser.media("light")
    found = []
    for width in WIDTHS:
        browser.ask("Emulation.setDeviceMetricsOverride", browser.session, width=width, height=800, deviceScaleFactor=1, mobile=False)
        if width == WIDTHS[0]:
            browser.open(page.as_uri())
            if not browser.wait(LOADED):
                return ["is not loaded after 90 s"]
            found += [f"the picture {name} is missing" for name in browser.value(PICTURES)]
        wide = browser.value(WIDE)
        found += [f"at {width} pixels: {wide}"] if wide else []
    if axe:
        browser.value(axe + "; 0")
        found += browser.value(AXE % RULES)
        browser.media("dark")
        found += [f"in the dark: {fault}" for fault in browser.value(AXE % CONTRAST)]
    return found + list(dict.fromkeys(browser.complaints))


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("chromium")
    parser.add_argument("site", type=Path)
    parser.add_argument("pages", nargs="*", help="files of the site; all of its first folder without")
    parser.add_argument("--axe", type=Path, help="axe.min.js of npm's axe-core")
    options = parser.parse_intermixed_args()
    site = options.site.resolve()
    pages = [site / name for name in options.pages] or sorted(site.glob("*.html"))
    axe = options.axe.read_text(encoding="utf-8") if options.axe else ""
    count = 0
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:  # the browser may still write there
        browser = Listener(options.chromium, profile)
        for page in pages:
            for fault in faults_of(browser, page, axe):
                count += 1
                print(f"{page.name}: {fault}", flush=True)
        browser.close()
    print(f"{len(pages)} pages, {count} faults" + ("" if axe else "; axe was not asked"))
    raise SystemExit(1 if count or not pages else 0)


if __name__ == "__main__":
    main()
