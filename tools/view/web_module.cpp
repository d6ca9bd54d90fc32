// What JavaScript calls: the functions of viewer.hpp, with text in and JSON out. Whatever goes wrong comes back as
// {"error": "the line that kreda would print"}. The text that comes back lives until the next call.
#include <new>
#include <string>

#include <nlohmann/json.hpp>

#include "tools/keys_json.hpp"
#include "tools/view/viewer.hpp"
#ifdef _OPENMP
#include "tools/view/openmp/omp.h"
#endif

#define KREDA_WEB extern "C" __attribute__((used, visibility("default")))

namespace {

using Json = nlohmann::ordered_json;
using kreda::tools::Viewer;

Viewer& viewer() {
    static Viewer only;
    return only;
}

const char* hand_over(const Json& answer) {
    static std::string text;
    text = answer.dump(-1, ' ', false, Json::error_handler_t::replace);
    return text.c_str();
}

template <class Work>
const char* answer(Work work) {
    try {
        return hand_over(work());
    } catch (const std::bad_alloc&) {
        return hand_over({{"error", "not enough memory; ask for a smaller image, fewer samples or less detail"}});
    } catch (const std::exception& error) { return hand_over({{"error", error.what()}}); }
}

/// A JSON array of strings.
std::vector<std::string> strings_of(const char* text) {
    return Json::parse(text).get<std::vector<std::string>>();
}

}  // namespace

KREDA_WEB const char* kreda_keys() {
    return answer([] { return kreda::tools::keys_as_json(); });
}

/// The file at this path ("": the built-in scene) with a JSON array of changes.
KREDA_WEB const char* kreda_open(const char* path, const char* overrides) {
    return answer([&] {
        open_scene(viewer(), path, strings_of(overrides));
        return describe(viewer());
    });
}

/// How often a file was read and decoded so far.
KREDA_WEB const char* kreda_reads() {
    return answer([] { return Json{{"reads", viewer().files.reads}}; });
}

/// How many threads took a part of a picture since this was asked.
KREDA_WEB const char* kreda_threads() {
#ifdef _OPENMP
    return answer([] { return Json{{"threads", kreda_threads_at_work()}}; });
#else
    return answer([] { return Json{{"threads", 1}}; });
#endif
}

/// [x, y, z of the position, of the target, of up], in the file's world.
KREDA_WEB void kreda_camera(double px, double py, double pz, double tx, double ty, double tz, double ux, double uy,
                            double uz) {
    move_camera(viewer(), {{px, py, pz}, {tx, ty, tz}, {ux, uy, uz}});
}

/// One frame. "pixels" is the address of width x height RGBA bytes, which live until the next call.
KREDA_WEB const char* kreda_draw(int width, int height, int samples, const char* view) {
    return answer([&] {
        choose_view(viewer(), view);
        set_size(viewer(), width, height, samples);
        const double ms = draw(viewer());
        const kreda::tools::ScreenPicture& picture = viewer().picture;
        return Json{{"ms", ms},
                    {"width", picture.width},
                    {"height", picture.height},
                    {"pixels", reinterpret_cast<std::uintptr_t>(picture.rgba.data())}};
    });
}

KREDA_WEB const char* kreda_explain(int x, int y) {
    return answer([&] { return explain_on_screen(viewer(), x, y); });
}

/// The scene file with a JSON array of changes.
KREDA_WEB const char* kreda_text(const char* overrides) {
    return answer([&] { return Json{{"text", changed_text(viewer(), strings_of(overrides))}}; });
}

/// The bits of the film that was drawn last, 16 hexadecimal digits.
KREDA_WEB const char* kreda_hash() {
    return answer([] {
        char digits[17];
        std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(hash_of_film(viewer())));
        return Json{{"hash", digits}};
    });
}
