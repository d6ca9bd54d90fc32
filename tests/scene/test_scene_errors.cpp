#include <doctest/doctest.h>

#include "scene/files/read_scene.hpp"
#include "scene/files/scene_keys.hpp"
#include "tests/scene/errors_and_views.hpp"

using namespace kreda::scene;
using kreda::tests::has;

namespace {

/// The message of the UserError; anything else that is thrown fails the test.
std::string complaint_about(const std::string& text) {
    try {
        const Scene scene = read_scene_text(text, "s.toml", ".");
    } catch (const UserError& error) { return error.what(); }
    return "no complaint";
}

/// The place alone: "s.toml:3:8".
std::string place(const std::string& text) {
    const std::string message = complaint_about(text);
    return message.substr(0, message.find(": "));
}

}  // namespace

TEST_CASE("An unknown key is reported where it stands with the nearest known one") {
    CHECK(complaint_about("[[material]]\nname = 'a'\n  shinines = 3\n") ==
          "s.toml:3:3: unknown key 'shinines' in [[material]]; did you mean 'shininess'?");
    CHECK(complaint_about("[camera]\nfov = 60\n") ==
          "s.toml:2:1: unknown key 'fov' in [camera]; did you mean 'vertical_fov'?");
    CHECK(complaint_about("[ambient]\nxylophone = 1\n") ==
          "s.toml:2:1: unknown key 'xylophone' in [ambient]; known keys: color");
}

TEST_CASE("An unknown table is reported where it stands with the nearest known one") {
    CHECK(complaint_about("\n[camra]\n") == "s.toml:2:2: unknown table [camra]; did you mean 'camera'?");
    CHECK(complaint_about("[[lights]]\n") == "s.toml:1:3: unknown table [lights]; did you mean 'light'?");
    CHECK(complaint_about("[qqqqqqqq]\n") ==
          "s.toml:1:2: unknown table [qqqqqqqq]; known tables: image, camera, shading, ambient, light, shadow, fog, "
          "environment, material, object");
    CHECK(complaint_about("near = 3\n") == "s.toml:1:1: 'near' is outside of any table; it belongs below [camera]");
}

TEST_CASE("A table that may be there once is written with one pair of brackets and the others with two") {
    CHECK(complaint_about("[light]\n") ==
          "s.toml:1:2: [light] must be [[light]]: there may be several, so it is written in double brackets");
    CHECK(complaint_about("[object]\nmesh = \"cube\"\n[object]\nmesh = \"sphere\"\n")
              .find("write each of them as [[object]]") != std::string::npos);
    CHECK(complaint_about("[camera]\nnear = 1\n[camera]\nfar = 9\n").find("[camera] is there twice") !=
          std::string::npos);
    CHECK(complaint_about("[[material]]\nmodel = \"blin_phong\"\n").find("did you mean \"blinn_phong\"?") !=
          std::string::npos);
    CHECK(complaint_about("[[camera]]\n") ==
          "s.toml:1:3: [[camera]] must be [camera]: there is only one, so it is written in single brackets");
    CHECK(complaint_about("camera = 3\n") ==
          "s.toml:1:1: 'camera' = ... must be [camera]: there is only one, so it is written in single brackets");
    CHECK(complaint_about("light = [1]\n") ==
          "s.toml:1:1: 'light' = ... must be [[light]]: there may be several, so it is written in double brackets");
}

TEST_CASE("A wrong type says what was found and what is expected with an example") {
    CHECK(complaint_about("[camera]\nposition = 'up'\n") ==
          "s.toml:2:12: 'position' in [camera] is the text \"up\"; expected 3 numbers, e.g. position = [0, 1, 4]");
    CHECK(complaint_about("[camera]\nposition = [0, 1]\n") ==
          "s.toml:2:12: 'position' in [camera] is a list of 2 values; expected 3 numbers, e.g. position = [0, 1, 4]");
    CHECK(complaint_about("[camera]\nup = [0, 'x', 0]\n") ==
          "s.toml:2:10: 'up' in [camera] is the text \"x\" in the second place; expected 3 numbers, "
          "e.g. up = [0, 1, 0]");
    CHECK(complaint_about("[image]\nsamples = 2.0\n") ==
          "s.toml:2:11: 'samples' in [image] is 2; expected a whole number in 1..8, e.g. samples = 1");
    CHECK(complaint_about("[[light]]\non = 1\n") ==
          "s.toml:2:6: 'on' in [[light]] is 1; expected true or false, e.g. on = true");
    CHECK(
        complaint_about("[shading]\ncull = 'bak'\n") ==
        "s.toml:2:8: 'cull' in [shading] is \"bak\"; did you mean \"back\"?; expected \"back\" | \"front\" | \"none\"");
    CHECK(complaint_about("[[light]]\nattenuation = 'weak'\n") ==
          "s.toml:2:15: 'attenuation' in [[light]] is \"weak\"; expected 3 numbers >= 0 or \"physical\"");
    CHECK(place("[[object]]\nmesh = 1979-05-27\n") == "s.toml:2:8");
    CHECK(place("[[object]]\nmesh = 'cube'\nhide = ['a', 2]\n") == "s.toml:3:14");
    CHECK(place("[camera.position]\n") == "s.toml:1:1");
}

TEST_CASE("NaN and infinity are refused everywhere") {
    for (const KeyInfo& info : scene_keys()) {
        for (const std::string bad : {"nan", "inf", "-inf", "1e300", "-1e300"}) {
            std::string value = bad;
            if (info.type == KeyType::vector || info.type == KeyType::vector_or_word) value = "[1, " + bad + ", 1]";
            if (info.type == KeyType::number_pair || info.type == KeyType::whole_pair) value = "[1, " + bad + "]";
            const std::string text = table_title(info.table) + "\n" + std::string(info.key) + " = " + value + "\n";
            CAPTURE(text);
            CHECK(has(complaint_about(text), "s.toml:2:"));
        }
    }
    CHECK(complaint_about("[camera]\nfar = inf\n") == "s.toml:2:7: 'far' in [camera] is inf; expected a finite number");
    CHECK(complaint_about("[[light]]\ncolor = [1, 1, nan]\n") ==
          "s.toml:2:16: 'color' in [[light]] is nan in the third place; expected a finite number");
    CHECK(complaint_about("[camera]\nposition = [1e300, 0, 0]\n") ==
          "s.toml:2:13: 'position' in [camera] is 1e+300 in the first place; numbers beyond 1e25 are refused");
}

TEST_CASE("Values out of range are refused at their place") {
    CHECK(complaint_about("[camera]\nnear = -1\n") ==
          "s.toml:2:8: 'near' in [camera] is -1; expected a number > 0, e.g. near = 0.1");
    CHECK(place("[camera]\nnear = 1e-50\n") == "s.toml:2:8");
    CHECK(place("[camera]\nvertical_fov = 0\n") == "s.toml:2:16");
    CHECK(place("[camera]\nvertical_fov = 180\n") == "s.toml:2:16");
    CHECK(place("[camera]\nvertical_fov = 179.9999999999\n") == "s.toml:2:16");  // 180 in float
    CHECK(place("[image]\nsize = [0, 3]\n") == "s.toml:2:9");
    CHECK(place("[image]\nsize = [3, 100000]\n") == "s.toml:2:12");
    CHECK(place("[image]\nsamples = 0\n") == "s.toml:2:11");
    CHECK(place("[image]\nsamples = 9\n") == "s.toml:2:11");
    CHECK(place("[image]\ngamma = 0\n") == "s.toml:2:9");
    CHECK(place("[image]\nexposure = -0.5\n") == "s.toml:2:12");
    CHECK(place("[[material]]\nshininess = -1\n") == "s.toml:2:13");
    CHECK(place("[fog]\ndensity = -1\n") == "s.toml:2:11");
    CHECK(place("[[light]]\ncone = [20, 181]\n") == "s.toml:2:13");
    CHECK(place("[[light]]\ncone = [-1, 30]\n") == "s.toml:2:9");
    CHECK(place("[[light]]\nattenuation = [1, 0, -1]\n") == "s.toml:2:22");
    CHECK(place("[ambient]\ncolor = [0, -0.1, 0]\n") == "s.toml:2:13");
}

TEST_CASE("Values that do not go together are refused") {
    CHECK(complaint_about("[camera]\nnear = 2\nfar = 1\n") ==
          "s.toml:3:7: 'far' in [camera] must be greater than 'near'");
    CHECK(place("[camera]\nnear = 100\n") == "s.toml:2:8");
    CHECK(complaint_about("[camera]\nposition = [0, 0, 0]\n") ==
          "s.toml:2:12: 'position' and 'target' in [camera] are the same point; move one of them");
    CHECK(has(complaint_about("[camera]\nup = [0, 0, 0]\n"), "s.toml:2:6: 'up' in [camera] has length 0"));
    CHECK(has(complaint_about("[camera]\nup = [0, -1, -4]\n"), "s.toml:2:6: 'up' in [camera] is parallel"));
    CHECK(has(complaint_about("[camera]\nposition = [0, 5, 0]\n"), "s.toml:2:12: 'up' in [camera] is parallel"));
    CHECK(has(complaint_about("[[light]]\ndirection = [0, 0, 0]\n"),
              "s.toml:2:13: 'direction' in [[light]] has length 0"));
    CHECK(complaint_about("[[light]]\nattenuation = [0, 0, 0]\n") ==
          "s.toml:2:15: 'attenuation' in [[light]] divides by zero; [1, 0, 0] means none");
    CHECK(complaint_about("[[light]]\ncone = [20, 20]\n") == "no complaint");  // a hard edge
    CHECK(complaint_about("[[light]]\ncone = [30, 20]\n") ==
          "s.toml:2:8: 'cone' in [[light]]: the first angle must not exceed the second");
    CHECK(complaint_about("[[material]]\nname = 'a'\n[[material]]\nname = 'a'\n") ==
          "s.toml:4:8: there is already a material 'a'; each [[material]] needs its own name");
}

TEST_CASE("The largest image is 16384 samples a side and 2^27 altogether") {
    CHECK(complaint_about("[image]\nsize = [16384, 8192]\n") == "no complaint");  // 2^14 x 2^13 = 2^27
    CHECK(complaint_about("[image]\nsize = [2048, 1024]\nsamples = 8\n") == "no complaint");
    CHECK(place("[image]\nsize = [16384, 8193]\n") == "s.toml:2:8");
    CHECK(complaint_about("[image]\nsize = [8193, 10]\nsamples = 2\n") ==
          "s.toml:2:8: the image has 16386 x 20 samples (size x samples); the largest is 16384 a side and 134217728 "
          "altogether");
}

TEST_CASE("An environment needs a file or a sky and a background needs an environment") {
    CHECK(complaint_about("[environment]\nrotation = 90\n") ==
          "s.toml:1:1: [environment] needs a file or a sky, e.g. file = \"studio.hdr\" or sky = \"studio\"");
    CHECK(complaint_about("[environment]\nsky = 'studio'\nfile = 'a.hdr'\n") ==
          "s.toml:3:8: 'file' and 'sky' in [environment] both give the light; remove one of them");
    CHECK(complaint_about("[environment]\nfile = 'no.hdr'\n") == "s.toml:2:8: 'file': 'no.hdr' is not there");
    CHECK(place("[environment]\nsky = 'noon'\n") == "s.toml:2:7");
    CHECK(complaint_about("[image]\nbackground = 'environment'\n") ==
          "s.toml:2:14: background = \"environment\" needs an [environment] that is on, e.g. sky = \"studio\"");
    CHECK(complaint_about("[image]\nbackground = 'environment'\n[environment]\nsky = 'sunset'\n") == "no complaint");
}

TEST_CASE("The microfacet model's constants have their ranges") {
    CHECK(place("[[material]]\nroughness = 1.5\n") == "s.toml:2:13");
    CHECK(place("[[material]]\nmetallic = -0.1\n") == "s.toml:2:12");
    CHECK(place("[[material]]\nior = [1.5, 0, 1.5]\n") == "s.toml:2:13");
    CHECK(complaint_about("[[material]]\nextinction = [3, 2, 1]\n") ==
          "s.toml:2:14: 'extinction' in [[material]] needs 'ior' beside it: a metal has both n and k");
    CHECK(complaint_about("[[material]]\nior = [1.5, 1.5, 1.5]\n") == "no complaint");
}

TEST_CASE("Keys of a material that contradict or lack each other are reported with the remedy") {
    const std::string start = "[[material]]\n";
    CHECK(complaint_about(start + "measured = 'gold'\nior = [1, 1, 1]\n") ==
          "s.toml:2:12: 'measured' and 'ior' in [[material]] both give n; remove one of them");
    CHECK(complaint_about(start + "spectrum = 'three'\n") ==
          "s.toml:2:12: 'spectrum' in [[material]] needs 'measured': only then more wavelengths are known, e.g. "
          "measured = "
          "\"gold\"");
    CHECK(complaint_about(start + "outside_ior = 1.33\n") ==
          "s.toml:2:15: 'outside_ior' in [[material]] needs 'ior' or 'measured': n of both sides");
    CHECK(complaint_about(start + "measured = 'gold'\nfresnel = 'corrected_schlick'\n") ==
          "s.toml:3:11: fresnel = \"corrected_schlick\" works with one n and k a channel; write spectrum = \"three\" "
          "beside it, or fresnel = \"f82\" for the whole spectrum");
    CHECK(complaint_about(start + "measured = 'gold'\nspectrum = 'three'\nfresnel = 'corrected_schlick'\n") ==
          "no complaint");
    CHECK(complaint_about(start + "grain = [0, 0, 0]\n") ==
          "s.toml:2:9: 'grain' in [[material]] has length 0; a direction is e.g. grain = [0, 1, 0]");
    CHECK(has(complaint_about(start + "measured = 'unobtainium'\n"), "expected \"gold\" | \"silver\""));
    CHECK(has(complaint_about(start + "ward_alpha = [0, 0.4]\n"), "s.toml:2:15: 'ward_alpha' in [[material]] is 0"));
}

TEST_CASE("Text that is not TOML is reported with its place") {
    CHECK(place("[camera]\nnear = \n") == "s.toml:2:8");
    CHECK(place("[camera]\nnear = 1\nnear = 2\n") == "s.toml:3:8");
    CHECK(has(complaint_about("[shading]\ncull = back\n"), "text needs quotes"));
    struct Habit {
        std::string text, remedy;
    };
    for (const Habit& habit :
         {Habit{"[[object]]\nmesh = \xe2\x80\x9c"
                "cube\xe2\x80\x9d\n",
                "write straight quotes"},
          Habit{"// a scene\n", "a comment begins with #"}, Habit{"{\"camera\": 1}\n", "TOML, not JSON"},
          Habit{"camera:\n  near: 1\n", "TOML writes key = value"},
          Habit{"[[object]]\nmesh = \"C:\\models\\a.obj\"\n", "write / between folders"},
          Habit{"[[light]]\nshadow = True\n", "true and false in small letters"},
          Habit{"[[light]]\nshadow = False\n", "true and false in small letters"},
          Habit{"[camera]\nnear = .5\n", "both sides of the point"},
          Habit{"[camera]\nnear = 1.\n", "both sides of the point"}}) {
        CAPTURE(habit.text);
        CHECK(has(complaint_about(habit.text), habit.remedy));
    }
    const std::string bracket = ": this is not TOML: expected a value or the right closing bracket";
    CHECK(complaint_about("[camera]\n# \xC3\xA9\nup = [0, }\nfar = 2\n") == "s.toml:3:10" + bracket);
    CHECK(complaint_about("x = [}") == "s.toml:1:6" + bracket);
    CHECK(place(std::string("[camera]\n\0near = 1\n", 18)) == "s.toml");
    CHECK(place("[camera]\nnear = \xFF\n").substr(0, 8) == "s.toml:2");
}

TEST_CASE("Deep nesting is an error and not the end of the stack") {
    std::string dots = "a";
    for (int i = 0; i < 200'000; ++i) dots += ".a";
    CHECK(has(complaint_about(dots + " = 1\n"), "s.toml:1: a key with more than 100 dots"));
    CHECK(has(complaint_about("[" + dots + "]\n"), "a key with more than 100 dots"));
    CHECK(place("x = " + std::string(100'000, '[')).substr(0, 8) == "s.toml:1");
}

TEST_CASE("A message is one line however long and strange the text it quotes") {
    const std::string message = complaint_about("\"a\\n" + std::string(1000, 'b') + "\" = 1\n");
    CHECK(message.find('\n') == std::string::npos);
    CHECK(message.size() < 300);
}

TEST_CASE("A file that cannot be read as a scene is one clear line") {
    const auto complaint_about = [](const std::string& path) -> std::string {
        try {
            const Scene scene = read_scene(path);
        } catch (const UserError& error) { return error.what(); }
        return "no complaint";
    };
    CHECK(complaint_about("/no/such/scene.toml") == "/no/such/scene.toml: cannot be opened: No such file or directory");
    CHECK(complaint_about("/") == "/: is a folder, not a scene file");
    CHECK(complaint_about("/dev/zero") == "/dev/zero: is a pipe or a device, not a scene file");
}
