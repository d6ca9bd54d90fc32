# Replays the gdb session that a page shows and holds it to the page:
#   KREDA_PAGE=docs/22_phong_terms.md KREDA_HELPERS=tools/debugger gdb -batch -x check_session.py --args PROGRAM ...
# Every "(gdb) command" of the page's blocks marked ```gdb is executed; every line below it must be in what gdb says, in
# that order. Lines that the page leaves out do not matter. Ends with 1 and tells where they part.
import os
import re
import sys

import gdb


def blocks_of(page):
    """The lines inside the page's ```gdb blocks."""
    lines, inside = [], False
    for line in open(page, encoding="utf-8"):
        if line.startswith("```"):
            inside = line.strip() == "```gdb"
        elif inside and line.strip():
            lines.append(line.strip())
    return lines


def steps_of(page):
    """(command, lines that it must print)"""
    steps = []
    for line in blocks_of(page):
        if line.startswith("(gdb) "):
            steps.append((line[len("(gdb) "):], []))
        else:
            steps[-1][1].append(line)
    return steps


def squeezed(text):
    return " ".join(text.split())


def first_missing(expected, output):
    """The first expected line that does not follow in the output; None: all are there. Numbers must be there as a whole."""
    at = 0
    for line in expected:
        pattern = r"(?<![\w.])" if line[0].isdigit() else ""
        pattern += re.escape(squeezed(line)) + r"(?![\d.]*\d)"
        found = re.search(pattern, output[at:])
        if not found:
            return line
        at += found.end()
    return None


MOVES = ("run", "continue", "next", "step", "finish", "up", "down", "pixel", "until")


def say(command):
    """What gdb prints for a command, and whether that is a complaint."""
    finished = gdb.selected_frame().function() if command == "finish" else None
    try:
        output = gdb.execute(command, to_string=True)
    except gdb.error as complaint:
        return str(complaint), True
    # where the program stopped, and what a function returned, are printed past execute()
    if command.split()[0] in MOVES and gdb.selected_inferior().pid:
        output += gdb.execute("frame", to_string=True)
    if command == "finish" and returns_something(finished):
        output += gdb.history(0).format_string()
    return output, False


def returns_something(function):
    return function is not None and function.type.target().code != gdb.TYPE_CODE_VOID


def fail(page, command, line, output):
    print("%s: after (gdb) %s\n  the page says: %s\n  gdb says:" % (page, command, line))
    print("\n".join("    " + text for text in output.splitlines()))
    sys.stdout.flush()
    gdb.execute("kill", to_string=True) if gdb.selected_inferior().pid else None
    os._exit(1)


def replay(page):
    steps = steps_of(page)
    if not steps:
        print("%s: shows no gdb session (a block that begins with ```gdb)" % page)
        os._exit(1)
    checked = 0
    for command, expected in steps:
        if command in ("quit", "q"):
            break
        output, is_error = say(command)
        if is_error and not expected:
            fail(page, command, "nothing of an error", output)
        missing = first_missing(expected, squeezed(output))
        if missing is not None:
            fail(page, command, missing, output)
        if os.environ.get("KREDA_SHOW"):
            print("(gdb) %s\n%s" % (command, output.rstrip()))
        checked += len(expected)
    if gdb.selected_inferior().pid:
        gdb.execute("kill", to_string=True)
    print("%s: %d commands, %d lines, as the page says" % (page, len(steps), checked))


gdb.execute("source " + os.environ["KREDA_HELPERS"] + "/kreda.py")
replay(os.environ["KREDA_PAGE"])
