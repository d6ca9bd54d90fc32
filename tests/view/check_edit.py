#!/usr/bin/env python3
"""Changes formulas in headless Chromium or Firefox: what a lesson begins with misses a test, the right formula passes all, a mistake
stands at its line, an endless loop is stopped, and the whole assignment gets the points of `kreda grade`.
Usage: check_edit.py CHROMIUM|FIREFOX KREDA FOLDER   (in the folder of the sources; out/compiler must be there)"""
import json
import shutil
import subprocess
import sys
from pathlib import Path

from browser import Browser
from firefox import Firefox

sys.path.insert(0, "docs/site")
import live_code

PROGRAM, KREDA, FOLDER = sys.argv[1:4]
ROOT = Path.cwd()
# What makes a lesson's text right: equation by equation.
MENDED = {"10": ("e_ab >= 0 && e_bc >= 0 && e_ca >= 0", " && ".join(
              f"(e_{a}{b} > 0 || (e_{a}{b} == 0 && is_top_left(t.{a}, t.{b})))" for a, b in ("ab", "bc", "ca"))),
          "21": ("cosine = n_dot_l;", "cosine = n_dot_l > 0.0f ? n_dot_l : 0.0f;"),
          "61": ("(void)n_view, (void)texel;\n    return 0.0f", "return 0.5f * (std::abs(texel.x * n_view.x) + "
                 "std::abs(texel.y * n_view.y)) / n_view.z")}
SLOW = 300  # seconds: machines that run other tests as well


class Page:
    def __init__(self, browser, address):
        self.browser = browser
        browser.open(address)
        assert browser.wait("globalThis.kreda && document.getElementById('code').value"), f"{address} does not start"
        browser.value("kreda.page.limit = 60000")  # this machine may be busy
        self.runs = 0

    def test(self, text=None):
        """Compile and test this text; the shown tests as {name: passed}."""
        if text is not None:
            self.browser.value(f"kreda.editor.text = {json.dumps(text)}")
        self.runs += 1
        self.browser.value("void kreda.test()")
        assert self.browser.wait(f"document.documentElement.dataset.runs === '{self.runs}'", SLOW), "it does not end: " + self.state()
        return self.browser.value("Object.fromEntries([...document.querySelectorAll('#tests li')].map(li => "
                                  "[li.querySelector('span').textContent.split(':')[0], li.querySelector('b').className === 'yes']))")

    def text(self):
        return self.browser.value("kreda.editor.text")

    def state(self):
        return self.browser.value("document.getElementById('state').textContent")


def check_missing(browser, folder):
    page = Page(browser, (folder / "edit/22.html").as_uri())
    page.test()
    assert "./course compiler" in page.state(), page.state()


def check_lesson(browser, folder, number):
    page = Page(browser, (folder / f"edit/{number}.html").as_uri())
    before = page.test()
    assert before and not all(before.values()), f"{number}: nothing is to be mended: {before}; {page.state()}"
    old, new = MENDED[number]
    assert old in page.text(), f"{number}: another text: {page.text()}"
    after = page.test(page.text().replace(old, new))
    assert all(after.values()), f"{number}: the right formula misses a test: {after}; {page.state()}"
    print(f"{number}: {sum(before.values())} of {len(before)} tests before, all after")
    return page


def check_mistakes(page):
    right = page.text()
    page.test(right.replace("return ", "retrun ", 1))
    line = right[:right.index("return ")].count("\n") + 1
    assert page.browser.value("[...document.querySelectorAll('#lines .bad')].map(e => e.textContent).join()") == str(line), page.state()
    assert page.browser.value("document.querySelector('#marks i b').textContent"), "no words stand at the line"
    assert "does not compile" in page.state(), page.state()
    page.browser.value("kreda.page.limit = 1000")
    page.test(right.replace("return ", "for (volatile int i = 0; i == 0;) {}\n    return ", 1))
    page.browser.value("kreda.page.limit = 60000")
    assert "was stopped after 1 s" in page.state(), page.state()
    again = page.test(right)
    assert all(again.values()), "after an endless loop nothing works: " + page.state()
    print("a mistake stands at its line; an endless loop is stopped")


def check_whole(browser, folder):
    """The same points and messages as the program's, for a file in which one function of the solution is wrong."""
    source = Path("examples/assignments/A1_coverage")
    text = (source / "teacher/solution.cpp").read_text(encoding="utf-8").replace("b.y < a.y", "b.y > a.y")
    work = folder / "student"
    work.mkdir(exist_ok=True)
    (work / "student.cpp").write_text(text, encoding="utf-8")
    subprocess.run([KREDA, "grade", work, "--rubric", source / "rubric.toml", "-o", folder / "graded", "--formats", "none"],
                   capture_output=True, check=False)
    expected = json.loads((folder / "graded/result.json").read_text(encoding="utf-8"))
    page = Page(browser, (folder / "edit/10.html").as_uri())
    browser.value("document.getElementById('which').value = 'whole'; document.getElementById('which').onchange()")
    page.test(text)
    result = json.loads(browser.value("kreda.page.result.file"))
    for key in ("assignment", "points", "max_points", "error", "submission"):
        assert result[key] == expected[key], f"{key}: {result[key]} in the browser, {expected[key]} by kreda grade"
    for mine, other in zip(result["tests"], expected["tests"], strict=True):
        for key in ("name", "points", "passed", "message", "measurements"):
            assert mine[key] == other[key], f"{mine['name']}, {key}: {mine[key]} in the browser, {other[key]} by kreda grade"
    assert result["diagnosis"] in expected["diagnosis"], f"{result['diagnosis']} / {expected['diagnosis']}"
    print(f"the whole of A1: {result['points']} of {result['max_points']} points in both")


def main():
    folder = Path(FOLDER).resolve() / "edit_site"
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    numbers = {number: "Lesson" for number in live_code.starts(ROOT)}
    live_code.write(ROOT, folder, numbers)
    compiler = folder / "compiler"
    browser = (Firefox if "firefox" in Path(PROGRAM).name else Browser)(PROGRAM, folder / "profile")
    try:
        compiler.rename(folder / "away")
        check_missing(browser, folder)
        (folder / "away").rename(compiler)
        check_mistakes(check_lesson(browser, folder, "10"))
        for number in ("21", "61"):
            check_lesson(browser, folder, number)
        check_whole(browser, folder)
    finally:
        browser.close()


main()
