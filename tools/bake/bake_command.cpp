// kreda bake: an environment's maps as files.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>
#include <vector>

#include <unistd.h>
#include <CLI/CLI.hpp>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "scene/files/read_environment.hpp"
#include "scene/files/scene_keys.hpp"
#include "tools/bake/bake.hpp"
#include "tools/commands.hpp"
#include "tools/progress_bar.hpp"
#include "tools/scene_options.hpp"
#include "tools/write_file.hpp"

namespace kreda::tools {

namespace {

namespace fs = std::filesystem;
using scene::Place;
using scene::UserError;

struct BakeOptions {
    std::string environment;  ///< a file, or a sky's name
    std::string output;
    float rotation = 0.0f;
    float intensity = 1.0f;
    int samples = scene::EnvironmentSettings{}.samples;
    std::string distribution = "ggx";
    std::string geometry = "schlick_ggx";
};

/// The words that a key of a scene file knows.
std::vector<std::string> words_of(const char* table, const char* key) {
    const std::vector<std::string_view>& words = scene::find_key(table, key)->words;
    return {words.begin(), words.end()};
}

int index_of(const std::vector<std::string>& words, const std::string& word) {
    const auto found = std::find(words.begin(), words.end(), word);
    return found == words.end() ? -1 : static_cast<int>(found - words.begin());
}

/// What a key of the environment allows. CLI::Range alone lets NaN pass.
CLI::Validator range_of(const char* key) {
    const scene::Range& range = scene::find_key("environment", key)->range;
    const CLI::Validator is_number(
        [](const std::string& text) {
            const bool is_nan = std::isnan(std::strtod(text.c_str(), nullptr));
            return is_nan ? text + " is no number" : std::string();
        },
        "");
    return is_number & CLI::Range(range.least, range.greatest);
}

/// Says what the word is not, and what it might have been.
[[noreturn]] void refuse_environment(const std::string& word, const std::vector<std::string>& skies) {
    std::string list;
    for (const std::string& sky : skies) list += (list.empty() ? "" : ", ") + sky;
    const std::string near = scene::nearest_word(word, skies);
    throw UserError(Place{word},
                    "is neither a file nor a built-in sky (" + list + ")" +
                        (near.empty() ? "; expected an equirectangular .hdr or .exr" : "; did you mean " + near + "?"));
}

BakeRequest read_request(const BakeOptions& options) {
    BakeRequest request;
    request.name = fs::path(options.environment).filename().string();
    scene::EnvironmentSettings& environment = request.environment;
    environment.on = true;
    environment.rotation_deg = options.rotation;
    environment.intensity = options.intensity;
    environment.samples = options.samples;
    request.brdf.distribution =
        static_cast<lighting::Distribution>(index_of(words_of("material", "distribution"), options.distribution));
    request.brdf.geometry =
        static_cast<lighting::Geometry>(index_of(words_of("material", "geometry"), options.geometry));
    const std::vector<std::string> skies = words_of("environment", "sky");
    const int sky = index_of(skies, options.environment);
    if (sky >= 0) {
        environment.sky = static_cast<lighting::Sky>(sky);
        return request;
    }
    std::error_code ignored;
    if (!fs::exists(options.environment, ignored)) refuse_environment(options.environment, skies);
    environment.file = options.environment;
    const scene::EnvironmentImage loaded =
        scene::read_environment_image(options.environment, Place{options.environment}, "");
    for (const std::string& remark : loaded.remarks) warn(options.environment + " " + remark);
    environment.image = loaded.image;
    request.repairs = loaded.repairs;
    return request;
}

/// Before anything is baked: nobody should wait for files that cannot be written.
void prepare_output(const std::string& folder) {
    make_folder(folder);
    if (access(folder.c_str(), W_OK | X_OK) != 0) {
        throw UserError(Place{folder}, "nothing can be written into this folder; choose another one with -o");
    }
}

void bake_command(const BakeOptions& options) {
    const BakeRequest request = read_request(options);
    prepare_output(options.output);
    const auto path = [&](const std::string& file) { return (fs::path(options.output) / file).string(); };
    std::vector<BakedFile> files;
    {
        ProgressBar bar("baking " + request.name);
        constexpr double kBaking = 1.0, kWriting = 1.0;  // writing takes about as long: EXR files are compressed
        const std::vector<lighting::Progress> steps = lighting::progress_of_steps(bar.progress(), {kBaking, kWriting});
        const lighting::EnvironmentMaps maps = bake_all(request, steps[0]);
        files = baked_files(maps);
        double all = 0.0;
        for (const BakedFile& file : files) all += static_cast<double>(file.picture.values.size());
        lighting::WorkCounter written(all, steps[1]);
        for (const BakedFile& file : files) {
            scene::write_exr(path(file.file), file.picture);
            written.add(static_cast<double>(file.picture.values.size()));
        }
        write_file(path("sh9.json"), sh9_json(request, maps, files));
        scene::write_png(path("contact_sheet.png"), bake_sheet(request, maps));
    }
    std::cerr << "wrote " << files.size() << " maps, sh9.json and contact_sheet.png to " << options.output << "\n";
}

constexpr const char* kBakeExamples = R"(
IMAGE should be twice as wide as high: Radiance (.hdr) and OpenEXR (.exr) hold light of any strength; PNG, JPEG, TIFF, WebP and
whatever else OpenImageIO reads end at 1, and their 8 or 16 bits are decoded as sRGB.
DIR gets, and files of the same names there are replaced:
  environment.exr        the environment as a cube map: six faces side by side, +x -x +y -y +z -z, as OpenGL stores them
  prefiltered_1.exr ...  the same as a surface of each roughness mirrors it; sh9.json says which file is which roughness
  irradiance.exr         the light that falls on a plane facing each direction
  brdf_map.exr           scale A (red) and bias B (green) of F0; to the right sqrt(n.v), downwards roughness, both 0 to 1
  sh9.json               irradiance as nine coefficients, the settings, and how many texels had to be repaired
  contact_sheet.png      all of them to look at
Numbers are linear 32-bit floats, those that kreda render computes with (rotation and intensity it applies later).

Examples:
  kreda bake dawn.hdr -o dawn
  kreda bake studio -o studio                              a built-in sky: studio, sunset, gradient
  kreda bake city.exr -o city --rotation 90 --intensity 2
  kreda bake dawn.hdr -o fine --samples 16384 --geometry smith_correlated)";

}  // namespace

void add_bake_command(CLI::App& app) {
    CLI::App* command = app.add_subcommand("bake", "Write the maps of light from an image or a sky as EXR files");
    const auto options = std::make_shared<BakeOptions>();
    command->add_option("environment", options->environment, "An equirectangular image, or the name of a built-in sky")
        ->type_name("IMAGE|SKY")
        ->required();
    command->add_option("-o,--output", options->output, "Folder for the files, made if need be")
        ->type_name("DIR")
        ->required();
    command->add_option("--rotation", options->rotation, "Degrees about +y, counter-clockwise seen from above")
        ->type_name("DEGREES")
        ->check(range_of("rotation"));
    command->add_option("--intensity", options->intensity, "Multiplies the light")
        ->type_name("FACTOR")
        ->check(range_of("intensity"));
    command->add_option("--samples", options->samples, "Samples a texel at roughness 1; by default 2048")
        ->type_name("N")
        ->check(range_of("samples"));
    command->add_option("--distribution", options->distribution, "D of the BRDF map; by default ggx")
        ->type_name("NAME")
        ->check(CLI::IsMember(words_of("material", "distribution")));
    command->add_option("--geometry", options->geometry, "G of the BRDF map; by default schlick_ggx")
        ->type_name("NAME")
        ->check(CLI::IsMember(words_of("material", "geometry")));
    command->footer(kBakeExamples);
    command->callback([options] { bake_command(*options); });
}

}  // namespace kreda::tools
