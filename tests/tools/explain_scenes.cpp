#include "tests/tools/explain_scenes.hpp"

#include "scene/files/image_file.hpp"
#include "scene/files/read_scene.hpp"
#include "scene/plan/environment_plan.hpp"
#include "tests/scene/temp_folder.hpp"

namespace kreda::tests {

namespace {

/// A ball before a wall, three lamps of all kinds. `model` and `more` are lines of the scene file.
std::string ball_and_wall(const std::string& material, const std::string& more) {
    return "[image]\nsize = [24, 16]\nbackground = [0.1, 0.2, 0.3]\n"
           "[camera]\nposition = [0.4, 0.6, 3]\nvertical_fov = 50\n"
           "[[light]]\ntype = \"directional\"\ndirection = [-1, -2, -1]\ncolor = [1, 0.9, 0.7]\n"
           "[[light]]\ntype = \"point\"\nposition = [2, 1, 1]\nattenuation = [1, 0.1, 0.2]\nintensity = 2\n"
           "[[light]]\ntype = \"spot\"\nposition = [-1, 2, 3]\ndirection = [1, -2, -3]\ncone = [5, 30]\n" +
           more + "[[material]]\nname = \"m\"\n" + material +
           "[[object]]\nmesh = \"sphere\"\ndetail = 10\nmaterial = \"m\"\n"
           "[[object]]\nmesh = \"plane\"\nmaterial = \"m\"\nrotate = [90, 0, 10]\ntranslate = [0, 0, -1.5]\nscale = "
           "1.2\n";
}

const std::string kShiny =
    "diffuse = [0.6, 0.3, 0.2]\nspecular = [0.5, 0.4, 0.3]\nemission = [0.01, 0, 0.02]\nshininess = 20\n";

std::string model(const std::string& name) {
    return "model = \"" + name + "\"\n" + kShiny;
}

std::string microfacets(const std::string& more) {
    return "model = \"cook_torrance\"\nalbedo = [0.9, 0.6, 0.3]\nmetallic = 0.4\nroughness = 0.35\n" + more;
}

/// Lit by a small image with something else in every texel, baked once for all pixels that are asked for.
void surround(scene::Scene& scene) {
    auto image = std::make_shared<raster::Image>(raster::make_image(8, 4, 3));
    for (std::size_t i = 0; i < image->values.size(); ++i) image->values[i] = static_cast<float>(i * 37 % 96) / 48.0f;
    scene.environment.image = image;
    scene.environment.prepared =
        std::make_shared<scene::PreparedEnvironment>(prepare_environment(scene.environment, environment_needs(scene)));
}

/// Three small pictures of numbers that are all different.
void write_textures(const TempFolder& folder) {
    raster::Image image = raster::make_image(8, 4, 3);
    for (std::size_t i = 0; i < image.values.size(); ++i)
        image.values[i] = 0.2f + 0.6f * static_cast<float>(i * 37 % 96) / 96.0f;
    scene::write_png(folder.file("colors.png"), image);
    image.channels = 1;
    image.values.resize(32);
    scene::write_png(folder.file("grey.png"), image);
    raster::Image bumps = raster::make_image(8, 4, 3);
    for (int i = 0; i < 32; ++i) {
        bumps.set_rgb(i % 8, i / 8,
                      {0.5f + 0.02f * static_cast<float>(i % 5), 0.45f + 0.02f * static_cast<float>(i % 7), 0.95f});
    }
    scene::write_png(folder.file("bumps.png"), bumps);
}

void replace_all(std::string& text, const std::string& old_words, const std::string& new_words) {
    for (std::size_t at = 0; (at = text.find(old_words, at)) != std::string::npos; at += new_words.size()) {
        text.replace(at, old_words.size(), new_words);
    }
}

std::vector<NamedScene> make_scenes() {
    std::vector<NamedScene> scenes;
    const TempFolder folder;
    write_textures(folder);
    const auto add = [&](const std::string& name, const std::string& material, const std::string& more = {},
                         bool shadows = false) {
        std::string text = ball_and_wall(material, more);
        if (shadows) replace_all(text, "[[light]]\n", "[[light]]\nshadow = true\n");
        scenes.push_back({name, scene::read_scene_text(text, name, folder.path.string())});
    };
    for (const char* name : {"unlit", "lambert", "phong", "blinn_phong", "ward", "heidrich_seidel"})
        add(name, model(name));
    for (const char* d : {"ggx", "beckmann", "blinn_phong", "gaussian"}) {
        add(std::string("D ") + d, microfacets(std::string("distribution = \"") + d + "\"\n"));
    }
    for (const char* g : {"smith", "smith_correlated", "implicit", "cook_torrance"}) {
        add(std::string("G ") + g, microfacets(std::string("geometry = \"") + g + "\"\n"));
    }
    for (const char* f : {"exact", "rescaled_schlick", "corrected_schlick", "f82", "table", "nvidia", "none",
                          "schlick_ior", "corrected_schlick_as_printed"}) {
        add(std::string("F ") + f, microfacets(std::string("fresnel = \"") + f + "\"\n"));
    }
    add("measured metal",
        microfacets("ior = [0.18, 0.42, 1.37]\nextinction = [3.42, 2.35, 1.77]\nfresnel = \"exact\"\n"));
    add("brushed", model("ward") + "ward_alpha = [0.1, 0.4]\ngrain = [1, 0, 0]\n");
    add("gold", microfacets("measured = \"gold\"\nfresnel = \"exact\"\n"));
    add("energy compensation", microfacets("energy_compensation = \"kulla_conty\"\n"));
    const std::string maps = "maps = \"" KREDA_SOURCE_DIR "/examples/44_materials/tiles/*.png\"\n";
    add("maps", microfacets(maps + "texture_scale = [3, 2]\n"));
    add("maps on a model without microfacets", model("phong") + maps + "texture_filter = \"bilinear\"\n");
    add("maps, nothing lit", model("unlit") + maps + "texture_filter = \"nearest\"\n");
    add("maps, green down", model("ward") + maps + "normal_map_y = \"down\"\ntexture_wrap = \"clamp\"\n");
    add("maps, gouraud", model("lambert") + maps, "[shading]\nfrequency = \"gouraud\"\n");
    add("maps, flat", microfacets(maps), "[shading]\nfrequency = \"flat\"\n");
    add("gouraud", model("phong"), "[shading]\nfrequency = \"gouraud\"\n");
    add("flat", model("phong"), "[shading]\nfrequency = \"flat\"\n");
    add("affine", model("phong"), "[shading]\ninterpolation = \"affine\"\n");
    add("flat in fog", model("phong"), "[shading]\nfrequency = \"flat\"\n[fog]\nmode = \"exp\"\n");
    add("fog linear planar", model("phong"), "[fog]\nmode = \"linear\"\nstart = 1\nend = 6\ndistance = \"planar\"\n");
    add("fog exp2", model("phong"), "[fog]\nmode = \"exp2\"\ndensity = 0.3\n");
    add("fog at vertices", model("phong"), "[fog]\nmode = \"exp\"\nfrequency = \"vertex\"\n");
    add("gouraud in fog", model("phong"),
        "[shading]\nfrequency = \"gouraud\"\n[fog]\nmode = \"exp\"\nfrequency = \"vertex\"\n");
    add("shadows", model("blinn_phong"), "[shadow]\nsize = 128\nfilter = \"pcf\"\n", true);
    add("shadows, flat", model("blinn_phong"), "[shading]\nfrequency = \"flat\"\n[shadow]\nsize = 128\n", true);
    add("maps", microfacets("albedo_map = \"colors.png\"\nroughness_map = \"grey.png\"\nnormal_map = \"bumps.png\"\n"));
    add("diffuse map", model("phong") + "diffuse_map = \"colors.png\"\ntexture_filter = \"bilinear\"\n");
    add("unlit map", model("unlit") + "diffuse_map = \"colors.png\"\n");
    add("emission map", model("phong") + "emission_map = \"colors.png\"\n");
    add("emission map, unlit", model("unlit") + "diffuse_map = \"grey.png\"\nemission_map = \"colors.png\"\n");
    add("emission map, microfacets", microfacets("emission_map = \"colors.png\"\nbump_map = \"grey.png\"\n"));
    add("no culling", model("phong"), "[shading]\ncull = \"none\"\n");
    const auto add_surrounded = [&](const std::string& name, const std::string& material,
                                    const std::string& environment) {
        add("environment, " + name, material, "[environment]\nsky = \"studio\"\nsamples = 32\n" + environment);
        surround(scenes.back().scene);
    };
    add_surrounded("split sum", microfacets("ao = 0.7\n"), "rotation = 40\nintensity = 0.5\n");
    add_surrounded("bounces", microfacets("energy_compensation = \"kulla_conty\"\nemission = [0.1, 0, 0.2]\n"),
                   "irradiance = \"sh9\"\n");
    add_surrounded("integral", microfacets(""), "reference = 16\n");
    add_surrounded("diffuse", model("blinn_phong"), "");
    scenes.back().scene.image.environment_background = true;
    surround(scenes.back().scene);
    add_surrounded("diffuse integral", model("lambert"), "reference = 16\n");
    for (NamedScene& named : scenes) named.scene.image.samples = 1;

    const auto vary = [&](const std::string& name, auto&& change) {
        NamedScene varied = scenes[2];  // phong
        varied.name = name;
        change(varied.scene);
        scenes.push_back(varied);
    };
    vary("3 x 3 samples", [](scene::Scene& s) { s.image.samples = 3; });
    vary("orthographic", [](scene::Scene& s) { s.camera.projection = raster::Projection::orthographic; });
    vary("through the near plane", [](scene::Scene& s) { s.camera.near = 2.4f; });
    vary("through the far plane", [](scene::Scene& s) { s.camera.far = 4.0f; });
    vary("mirrored", [](scene::Scene& s) { s.objects[0].world_from_object[0] *= -1.0f; });
    vary("film", [](scene::Scene& s) {
        s.image.exposure = 1.7f;
        s.image.tone_map = raster::ToneMap::reinhard_extended;
        s.image.transfer = raster::Transfer::gamma;
    });
    vary("empty", [](scene::Scene& s) { s.objects.clear(); });
    return scenes;
}

}  // namespace

const std::vector<NamedScene>& scenes_to_explain() {
    static const std::vector<NamedScene> scenes = make_scenes();
    return scenes;
}

}  // namespace kreda::tests
