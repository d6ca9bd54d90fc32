# What gdb shows of GLM's types and of ours: a vector as (x, y, z), a matrix as rows like on the slide, an image on one line,
# a float with six digits (2.49, not 2.49000001). `print /r` shows everything as it is.
import glob
import re
import struct
import sys

import gdb
import gdb.printing


def number(value):
    """Six significant digits; a whole number without a point; no -0."""
    return "%.6g" % (float(value) + 0.0)


def vec_text(value):
    letters = [field.name for field in value.type.strip_typedefs().fields()]
    parts = [value[letter] for letter in letters]
    if parts[0].type.strip_typedefs().code == gdb.TYPE_CODE_FLT:
        return "(" + ", ".join(number(part) for part in parts) + ")"
    return "(" + ", ".join(str(int(part)) for part in parts) + ")"


def mat_rows(value):
    """The rows of a matrix, although GLM keeps columns."""
    columns = [column for column in array_items(value["value"])]
    letters = [field.name for field in columns[0].type.strip_typedefs().fields()]
    return [[float(column[letter]) for column in columns] for letter in letters]


def mat_text(value):
    rows = [[number(x) for x in row] for row in mat_rows(value)]
    width = max(len(x) for row in rows for x in row)
    lines = ["  [ " + "  ".join(x.rjust(width) for x in row) + " ]" for row in rows]
    return "%dx%d, row by row\n%s" % (len(rows), len(rows[0]), "\n".join(lines))


def array_items(value):
    low, high = value.type.strip_typedefs().range()
    return [value[i] for i in range(low, high + 1)]


def vector_size(value):
    """Number of elements of a std::vector (of GCC's library)."""
    return int(value["_M_impl"]["_M_finish"] - value["_M_impl"]["_M_start"])


def read_floats(address, count):
    memory = gdb.selected_inferior().read_memory(int(address), 4 * count)
    return struct.unpack("%df" % count, bytes(memory))


def vector_floats(value):
    count = vector_size(value)
    return read_floats(value["_M_impl"]["_M_start"], count) if count else ()


def range_text(values):
    return "%s .. %s" % (number(min(values)), number(max(values))) if values else "empty"


def image_text(value):
    size = "%d x %d, %d channels" % (int(value["width"]), int(value["height"]), int(value["channels"]))
    return "Image " + size + ", values " + range_text(vector_floats(value["values"]))


def depth_text(depth):
    covered = [z for z in depth if z < 1.0]
    return "%d covered, depth %s" % (len(covered), range_text(covered))


def visibility_text(value):
    size = "%d x %d samples" % (int(value["width"]), int(value["height"]))
    return "VisibilityBuffer " + size + ", " + depth_text(vector_floats(value["depth"]))


def tile_visibility_text(value):
    depth = value["depth"]
    count = depth.type.range()[1] + 1
    return "TileVisibility, " + depth_text(read_floats(depth.address, count))


def channel_text(value):
    return "point 0: " + number(value["value"][0])


def channel3_text(value):
    return "point 0: (%s, %s, %s)" % (number(value["x"][0]), number(value["y"][0]), number(value["z"][0]))


def pixels(subpixels):
    return number(int(subpixels) / 256.0)


def even_or_channel_text(value):
    return "at every point %s" % vec_text(value["even"]) if value["is_even"] else channel3_text(value["each"])


def surface_channels_text(value):
    if not value["is_even"]:
        return "{albedo = %s, ...}" % channel3_text(value["albedo"])
    even = value["even"]
    return "at every point {albedo = %s, f0 = %s, metallic = %s, roughness = %s, alpha = %s}" % (
        vec_text(even["albedo"]), vec_text(even["f0"]), *(number(even[c]) for c in ("metallic", "roughness", "alpha")))


def screen_vertex_text(value):
    place = "x = %d (pixel %s), y = %d (pixel %s)" % (
        int(value["x"]), pixels(value["x"]), int(value["y"]), pixels(value["y"]))
    return "{%s, z = %s, inv_w = %s}" % (place, number(value["z"]), number(value["inv_w"]))


def mesh_text(value):
    return "Mesh of %d corners, %d triangles" % (vector_size(value["positions"]), vector_size(value["indices"]) // 3)


def streams_text(value):
    kept = [field.name for field in value.type.strip_typedefs().fields() if vector_size(value[field.name]) > 0]
    return "VertexStreams of %d vertices: %s" % (vector_size(value["screen"]), ", ".join(kept))


def triangle_set_text(value):
    chunks = value["chunks"]
    first = chunks["_M_impl"]["_M_start"]
    drawn = sum(vector_size((first + i).dereference()["triangles"]) for i in range(vector_size(chunks)))
    tiles = "%d x %d tiles" % (int(value["grid"]["columns"]), int(value["grid"]["rows"]))
    return "TriangleSet of %d triangles in %s" % (drawn, tiles)


def scene_text(value):
    size = "%d x %d" % (int(value["image"]["width"]), int(value["image"]["height"]))
    counts = ", ".join("%d %s" % (vector_size(value[part]), part) for part in ("objects", "lights", "materials"))
    return "Scene %s: %s" % (size, counts)


def plan_text(value):
    size = "%d x %d samples" % (int(value["viewport"]["width"]), int(value["viewport"]["height"]))
    return "RenderPlan for %s, %d a pixel side, shading %s" % (size, int(value["samples"]), value["frequency"])


# Type names that gdb gives, and what shows them. Types of ours that are not here are shown field by field.
PRINTERS = [
    ("vec", r"^glm::vec<\d, .*>$", vec_text),
    ("mat", r"^glm::mat<\d, \d, .*>$", mat_text),
    ("Image", r"^kreda::raster::Image$", image_text),
    ("VisibilityBuffer", r"^kreda::raster::VisibilityBuffer$", visibility_text),
    ("TileVisibility", r"^kreda::raster::TileVisibility$", tile_visibility_text),
    ("Channel", r"^kreda::raster::Channel$", channel_text),
    ("Channel3", r"^kreda::raster::Channel3$", channel3_text),
    ("EvenOrChannel", r"^kreda::lighting::EvenOrChannel$", even_or_channel_text),
    ("SurfaceChannels", r"^kreda::lighting::SurfaceChannels$", surface_channels_text),
    ("ScreenVertex", r"^kreda::raster::ScreenVertex$", screen_vertex_text),
    ("Mesh", r"^kreda::raster::Mesh$", mesh_text),
    ("VertexStreams", r"^kreda::raster::VertexStreams$", streams_text),
    ("TriangleSet", r"^kreda::raster::TriangleSet$", triangle_set_text),
    ("Scene", r"^kreda::scene::Scene$", scene_text),
    ("RenderPlan", r"^kreda::scene::RenderPlan$", plan_text),
]


class OneLine:
    """Shows a value as the text that a function makes of it."""

    def __init__(self, value, text):
        self.value = value
        self.text = text

    def to_string(self):
        try:
            return self.text(self.value)
        except (gdb.error, gdb.MemoryError) as error:  # not initialized yet
            return "<not readable: %s>" % error


class KredaPrinters(gdb.printing.PrettyPrinter):
    def __init__(self):
        super().__init__("kreda", [])
        self.known = [(re.compile(pattern), text) for _, pattern, text in PRINTERS]

    def __call__(self, value):
        if value.type.code == gdb.TYPE_CODE_REF:
            value = value.referenced_value()
        basic = value.type.strip_typedefs().unqualified()
        name = str(basic)
        if basic.code == gdb.TYPE_CODE_FLT and basic.sizeof == 4:
            return OneLine(value, number)
        for pattern, text in self.known:
            if pattern.match(name):
                return OneLine(value, text)
        return None


def register_standard_library():
    """std::vector and friends. GCC brings their printers, but Debian's gdb looks for them in another folder."""
    for folder in glob.glob("/usr/share/gcc*/python"):
        sys.path.append(folder)
    try:
        from libstdcxx.v6.printers import register_libstdcxx_printers
        from libstdcxx.v6.xmethods import register_libstdcxx_xmethods
        register_libstdcxx_printers(None)
        register_libstdcxx_xmethods(None)
    except (ImportError, RuntimeError):  # not installed, or registered already
        pass


def register():
    register_standard_library()
    gdb.printing.register_pretty_printer(None, KredaPrinters(), replace=True)
