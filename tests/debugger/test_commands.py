# The helpers' commands and printers, on `kreda render everything.toml`, a scene that goes through all stages.
import os
import re
import sys

import gdb


def say(command):
    """What gdb prints; a command's complaint counts as that."""
    try:
        return gdb.execute(command, to_string=True)
    except gdb.error as error:
        return str(error)


def expect(failures, command, pattern):
    output = say(command)
    if re.search(pattern, output, re.S):
        return
    failures.append(command)
    print("(gdb) %s\n%s\n  does not match %s" % (command, output, pattern))


def check_stages(failures):
    """Run through: the stages are reached in the order of the list, each of them."""
    expect(failures, "point", "not running; stop at a pixel first")
    say("tbreak make_plan")  # planning where a light's map must reach calls the clipper, too: what is drawn comes behind it
    say("run")
    say("finish")
    names = [line.split()[1] for line in say("stages break").splitlines() if line.split()[0].isdigit()][1:]
    reached = []
    say("continue")
    while gdb.selected_inferior().pid:
        frame = gdb.newest_frame()
        reached.append(re.match(r"(?:\w+::|\(anonymous namespace\)::)*(\w+)", frame.function().name).group(1))
        say("continue")
    print("stages: " + " ".join(reached))
    if reached != names or len(names) < 12:
        failures.append("stages")
        print("  but the list says: " + " ".join(names))


def check_pixel(failures):
    expect(failures, "pixel", "usage: pixel X Y")
    expect(failures, "pixel 3 x", "usage: pixel X Y")
    expect(failures, "pixel 3 -4", "usage: pixel X Y")
    expect(failures, "pixel 3 4 0", "usage: pixel X Y")
    expect(failures, "pixel 500 20", r"no picture has a pixel \(500, 20\).*1: 96 x 64")
    expect(failures, "pixel 5 4 2", r"no picture has a pixel \(5, 4\).*1: 96 x 64")
    expect(failures, "pixel 1 0", "No triangle covers pixel .1, 0. of picture 1 .96 x 64.: it shows the background")
    expect(failures, "break shade_points", "Breakpoint")
    expect(failures, "pixel 48 40", "Pixel .48, 40. of picture 1 .96 x 64. is shaded next")
    expect(failures, "info breakpoints", "keep y .*shade_points")
    say("continue")
    expect(failures, "frame", "shade_points")
    expect(failures, "print points.count", "= 1\n")


def check_printers(failures):
    three = r"\([-\d.e]+, [-\d.e]+, [-\d.e]+\)"
    expect(failures, "print frame.scene", "= Scene 96 x 64: 2 objects, 1 lights, 2 materials")
    expect(failures, "print frame.plan", "= RenderPlan for 192 x 128 samples, 2 a pixel side")
    expect(failures, "print frame.scene.camera.position", r"= \(0, 1.5, 4\)")
    expect(failures, "print frame.scene.objects[1].world_from_object",
           r"4x4, row by row\s+\[ +1 +0 +0 +0.5 \]\s+\[ +0 +1 +0 +0.25 \]\s+\[ +0 +0 +1 +-0.75 \]\s+\[ +0 +0 +0 +1 \]")
    expect(failures, "print frame.buffers.film", "= Image 96 x 64, 3 channels, values ")
    expect(failures, "print frame.buffers.triangles", r"= TriangleSet of \d+ triangles in \d+ x \d+ tiles")
    expect(failures, "print frame.buffers.streams", r"= VertexStreams of \d+ vertices: screen, position_world, normal_world")
    expect(failures, "print frame.buffers.streams.screen[0]", r"= {x = -?\d+ \(pixel ")
    expect(failures, "print *frame.scene.objects[0].mesh.get()", "= Mesh of 4 corners, 2 triangles")
    expect(failures, "print points.position", "= point 0: " + three)
    expect(failures, "info args", "points = .*count = 1")
    expect(failures, "next", "")
    expect(failures, "point", r"position +" + three + r".*\bn +\(.*radiance")
    expect(failures, "point x", "usage: point")
    say("frame function render_tile")
    expect(failures, "print scratch.visibility", r"= TileVisibility, \d+ covered, depth 0.\d+ .. 0.\d+")


def check_save(failures):
    expect(failures, "save-png", "usage: save-png IMAGE FILE")
    expect(failures, "save-png frame.scene scene.png", "frame.scene is no image but a .*Scene")
    for image in ("depth", "film", "frame.buffers.film", "scratch.visibility"):
        expect(failures, "save-png %s saved.png" % image, "saved saved.png")
        if open("saved.png", "rb").read(8) != b"\x89PNG\r\n\x1a\n":
            failures.append("no PNG of " + image)
        os.remove("saved.png")
    expect(failures, "save-png film no/such/folder.png", "nothing was saved")


def check_steps(failures):
    """`step` goes from the whole formula into its steps, not into GLM."""
    expect(failures, "delete", "")
    expect(failures, "break blinn_phong", "Breakpoint")
    expect(failures, "pixel 48 40", "shaded next")
    say("continue")
    for _ in range(12):
        say("step")
        if gdb.newest_frame().name().endswith("::sigma_blinn"):
            return
    failures.append("step")


gdb.execute("source " + os.environ["KREDA_HELPERS"] + "/kreda.py")
gdb.execute("set args render %s -o everything.png" % os.environ["KREDA_SCENE"])
failures = []
for check in (check_stages, check_pixel, check_printers, check_save, check_steps):
    check(failures)
gdb.execute("kill")
print("failed: %s" % failures if failures else "all as they should be")
sys.stdout.flush()
os._exit(1 if failures else 0)
