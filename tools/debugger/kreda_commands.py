# The commands for a course: pixel X Y [PICTURE], save-png IMAGE FILE, point [I], stages [break].
import gdb

from kreda_printers import number

DEBUG_PIXEL = "'kreda::scene::debug_pixel'"


class PictureCounter(gdb.Breakpoint):
    """Counts the pictures a program draws and asks for the pixel in the one that is wanted; never stops."""

    def __init__(self, x, y, picture):
        super().__init__("kreda::scene::picture_begins", internal=True)
        self.x, self.y, self.picture = x, y, picture
        self.sizes = []

    def stop(self):
        frame = gdb.newest_frame()
        self.sizes.append((int(frame.read_var("width")), int(frame.read_var("height"))))
        if self.picture in (None, len(self.sizes)):
            ask_for_pixel(self.x, self.y)
        elif self.picture < len(self.sizes):
            ask_for_pixel(-1, -1)
        return False


class SilentStop(gdb.Breakpoint):
    """Stops without a word of its own."""

    def __init__(self, function):
        super().__init__("kreda::scene::" + function, internal=True)
        self.silent = True
        self.stopped = False

    def stop(self):
        self.stopped = True
        return True


def ask_for_pixel(x, y):
    gdb.execute("set variable %s.x = %d" % (DEBUG_PIXEL, x))
    gdb.execute("set variable %s.y = %d" % (DEBUG_PIXEL, y))


def is_running():
    return gdb.selected_inferior().pid != 0


def is_at_start():
    """Stopped at the program's entry, as editors do."""
    return is_running() and gdb.newest_frame().name() == "main"


def whole_numbers(arguments, usage):
    try:
        return [int(text) for text in arguments]
    except ValueError:
        raise gdb.GdbError(usage)


class Pixel(gdb.Command):
    """Stop where one pixel is shaded: pixel X Y [PICTURE]

Starts the program (anew) and stops once, when the pixel in column X and row Y is to be shaded. Row 0 is on top.
Programs that draw several pictures: PICTURE is the number of the one that is meant, from 1; without it, the first
one that has such a pixel. The pixel is shaded in a batch of its own: in every loop over a batch, i is 0.
Your own breakpoints rest until the pixel is reached."""

    USAGE = "usage: pixel X Y [PICTURE], whole numbers; X is the column, Y the row, from 0; PICTURE counts from 1"

    def __init__(self):
        super().__init__("pixel", gdb.COMMAND_RUNNING)

    def invoke(self, argument, from_tty):
        wanted = whole_numbers(gdb.string_to_argv(argument), self.USAGE)
        if len(wanted) not in (2, 3) or min(wanted) < 0 or (len(wanted) == 3 and wanted[2] < 1):
            raise gdb.GdbError(self.USAGE)
        x, y = wanted[:2]
        picture = wanted[2] if len(wanted) == 3 else None
        resting = [b for b in gdb.breakpoints() if b.enabled]
        for breakpoint in resting:
            breakpoint.enabled = False
        ours = [PictureCounter(x, y, picture), SilentStop("pixel_reached"), SilentStop("pixel_not_covered")]
        try:
            self.run_to_pixel(x, y, *ours)
        finally:
            for breakpoint in ours:
                breakpoint.delete()
            for breakpoint in resting:
                if breakpoint.is_valid():
                    breakpoint.enabled = True

    def run_to_pixel(self, x, y, counter, reached, not_covered):
        gdb.execute("continue" if is_at_start() else "run", to_string=True)
        if not is_running():
            raise gdb.GdbError(self.why_not(x, y, counter))
        if not (reached.stopped or not_covered.stopped):
            return  # something else stopped the program, an error of its own or Ctrl-C
        ask_for_pixel(-1, -1)
        picture = "picture %d (%d x %d)" % ((len(counter.sizes),) + counter.sizes[-1])
        gdb.execute("finish", to_string=True)
        if not_covered.stopped:
            print("No triangle covers pixel (%d, %d) of %s: it shows the background." % (x, y, picture))
            return
        print("Pixel (%d, %d) of %s is shaded next, in a batch of its own: i is 0." % (x, y, picture))

    def why_not(self, x, y, counter):
        code = gdb.convenience_variable("_exitcode")
        if code is not None and int(code) != 0:
            return "pixel: the program ended with exit code %d" % int(code)
        if not counter.sizes:
            return "pixel: this program shades no pixels with scene/render/render.cpp; use break (see the example's page)"
        sizes = ", ".join("%d: %d x %d" % (i + 1, w, h) for i, (w, h) in enumerate(counter.sizes[:12]))
        return "pixel: no picture has a pixel (%d, %d) there; the program drew %s" % (x, y, sizes)


class SavePng(gdb.Command):
    """Save an image as PNG: save-png IMAGE FILE

IMAGE is an expression for an Image (taken as linear RGB or grey), for a VisibilityBuffer or a TileVisibility (their depth:
near is bright, far is dark, nothing is black), or one of the words
  depth   the depth of the whole picture that is being drawn
  film    the pixels of that picture which are shaded already"""

    FUNCTIONS = {"kreda::raster::Image": "kreda_save_image", "kreda::raster::VisibilityBuffer": "kreda_save_visibility",
                 "kreda::raster::TileVisibility": "kreda_save_tile"}
    FRAME_FUNCTIONS = {"depth": "kreda_save_frame_depth", "film": "kreda_save_frame_film"}

    def __init__(self):
        super().__init__("save-png", gdb.COMMAND_DATA)

    def invoke(self, argument, from_tty):
        expression, _, file = argument.strip().rpartition(" ")
        if not expression:
            raise gdb.GdbError("usage: save-png IMAGE FILE, for example save-png depth depth.png")
        if expression in self.FRAME_FUNCTIONS:
            function, image = self.FRAME_FUNCTIONS[expression], frame_of_picture()
        else:
            image = without_reference(gdb.parse_and_eval(expression))
            function = self.FUNCTIONS.get(str(image.type.strip_typedefs().unqualified()))
            if function is None:
                raise gdb.GdbError("save-png: %s is no image but a %s" % (expression, image.type))
        saved = gdb.parse_and_eval(function)(image.address, file + "\0")
        if not saved:
            raise gdb.GdbError("save-png: nothing was saved")
        print("saved " + file)


def without_reference(value):
    return value.referenced_value() if value.type.code in (gdb.TYPE_CODE_REF, gdb.TYPE_CODE_PTR) else value


def variables_of_stack():
    """(name, value) of arguments and locals, innermost frame first, references followed."""
    if not is_running():
        raise gdb.GdbError("the program is not running; stop at a pixel first (pixel X Y)")
    frame = gdb.selected_frame()
    while frame is not None and frame.is_valid():
        try:
            block = frame.block()
        except RuntimeError:  # a frame of a library without symbols
            block = None
        while block is not None and not block.is_global and not block.is_static:
            for symbol in block:
                if symbol.is_argument or symbol.is_variable:
                    try:
                        value = symbol.value(frame)
                        yield symbol.name, value.referenced_value() if value.type.code == gdb.TYPE_CODE_REF else value
                    except (gdb.error, gdb.MemoryError, TypeError):
                        pass
            block = block.superblock if block.function is None else None
        frame = frame.older()


def find_on_stack(type_name):
    for _, value in variables_of_stack():
        if str(value.type.strip_typedefs().unqualified()) == type_name:
            return value
    return None


def frame_of_picture():
    frame = find_on_stack("kreda::scene::Frame")
    if frame is None:
        raise gdb.GdbError("save-png: no picture is being drawn here; stop at a pixel first (pixel X Y)")
    return frame


class Point(gdb.Command):
    """Show what is known of one point of the batch: point [I]

Prints every channel of the batch that the functions on the stack work on, at point I (default 0)."""

    BATCHES = ("kreda::raster::Fragments", "kreda::lighting::LightingChannels")

    def __init__(self):
        super().__init__("point", gdb.COMMAND_DATA)

    def invoke(self, argument, from_tty):
        lane = whole_numbers([argument or "0"], "usage: point [I], a whole number")[0]
        found = [batch for batch in map(find_batch, self.BATCHES) if batch is not None]
        if not found:
            raise gdb.GdbError("point: no batch is on the stack here; stop at a pixel first (pixel X Y)")
        zero = []
        for batch in found:
            zero += print_channels(batch, lane, "")
        print("  0, or not asked for:   " + ", ".join(zero))


def find_batch(type_name):
    batch = find_on_stack(type_name)
    if batch is not None:
        return batch
    scratch = find_on_stack("kreda::scene::TileScratch")
    return None if scratch is None else owned_by(scratch["fragments" if type_name.endswith("Fragments") else "lighting"])


def owned_by(unique_pointer):
    """What a std::unique_ptr points to, or None: with its usual deleter it is one pointer wide."""
    pointer = unique_pointer.type.strip_typedefs().template_argument(0).pointer()
    address = unique_pointer.address.cast(pointer.pointer()).dereference()
    return address.dereference() if int(address) else None


def print_channels(batch, lane, prefix):
    """A line for each channel that is not 0 at this point; returns the names of the others."""
    zero = []
    for field in batch.type.strip_typedefs().fields():
        value, name = batch[field.name], prefix + field.name
        kind = str(value.type.strip_typedefs().unqualified())
        if kind == "kreda::lighting::SurfaceChannels" and value["is_even"]:
            zero += print_channels(value["even"], lane, name + ".")
            continue
        if kind == "float":
            numbers = [value]
        elif kind.startswith("glm::vec<3"):
            numbers = [value[c] for c in "xyz"]
        elif kind == "kreda::raster::Channel":
            numbers = [value["value"][lane]]
        elif kind == "kreda::raster::Channel3":
            numbers = [value[c][lane] for c in "xyz"]
        elif kind == "kreda::lighting::EvenOrChannel":
            numbers = [value["even"][c] if value["is_even"] else value["each"][c][lane] for c in "xyz"]
        else:
            if value.type.strip_typedefs().code == gdb.TYPE_CODE_STRUCT:
                zero += print_channels(value, lane, name + ".")
            continue
        if any(float(x) != 0.0 for x in numbers):
            text = ", ".join(number(x) for x in numbers)
            print("  %-22s %s" % (name, "(%s)" % text if len(numbers) == 3 else text))
        else:
            zero.append(name)
    return zero


# The way of a picture, in order: function, what it does, what to look at.
STAGES = [
    ("kreda::scene::make_plan", "what the scene requires", "scene"),
    ("kreda::raster::transform_vertices", "vertices: object -> world -> clip -> screen", "streams"),
    ("kreda::raster::to_screen", "one vertex: divide by w, viewport, snap to 1/256", "clip, inv_w, ndc, window"),
    ("build_shadow", "draw a light's shadow map, or build its tree", "planned"),
    ("kreda::raster::setup_triangles", "cull, clip, sort into tiles", "set"),
    ("kreda::raster::clip_triangle", "cut at the near plane and the guard band", "polygon.count"),
    ("kreda::raster::rasterize_tile", "the nearest triangle at every sample of a tile", "area, tile"),
    ("kreda::raster::interpolate_runs", "attributes of the visible samples", "fragments"),
    ("shade_points", "light one batch of points", "point"),
    ("surface_directions", "n and v", "point"),
    ("sample_light", "l and what the light sends", "light, point"),
    ("set_shadow", "what share of that light arrives", "point"),
    ("add_reflection", "one light's diffuse and specular", "setup, point"),
    ("fog_factors", "f", "point"),
    ("apply_fog", "mix with the fog's colour", "point"),
    ("write_film", "the mean of each pixel's samples", "color"),
    ("kreda::raster::develop", "exposure, tone map, sRGB", "film"),
    ("kreda::scene::write_png", "8 bits a channel", "encoded"),
]


class Stages(gdb.Command):
    """List the pipeline's stages in order: stages [break]

Every line is a function to break at and what to look at there. "stages break" sets a breakpoint at each, which
stops once."""

    def __init__(self):
        super().__init__("stages", gdb.COMMAND_BREAKPOINTS)

    def invoke(self, argument, from_tty):
        if argument not in ("", "break"):
            raise gdb.GdbError("usage: stages [break]")
        for i, (function, what, look_at) in enumerate(STAGES):
            here = "" if is_in_program(function) else "  (not in this program)"
            print("%2d  %-18s %-50s %s%s" % (i + 1, function.split("::")[-1], what, look_at, here))
        for function, _, _ in STAGES if argument == "break" else []:
            if is_in_program(function):
                gdb.Breakpoint(function, temporary=True)


def is_in_program(function):
    try:
        return gdb.decode_line(function)[1] is not None
    except gdb.error:
        return False


def register():
    for command in (Pixel, SavePng, Point, Stages):
        command()
