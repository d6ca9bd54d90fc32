// kreda render --watch: draws again when a file of the scene is saved, tells errors and goes on, and ends with Ctrl-C.
#include <chrono>
#include <csignal>
#include <filesystem>
#include <functional>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <doctest/doctest.h>

#include "scene/error.hpp"
#include "scene/files/image_file.hpp"
#include "tests/scene/temp_folder.hpp"
#include "tests/tools/run_kreda.hpp"

using namespace kreda;
using namespace kreda::tests;

namespace {

std::string scene_of_color(const std::string& color) {
    return "[image]\nsize = [32, 16]\nbackground = " + color + "\n";
}

/// A program that watches a.toml in a folder and draws a.png; it is ended with the object.
struct Watcher {
    TempFolder folder;
    TempFolder log;  ///< beside: what appears in the folder may mean something
    pid_t child = -1;

    explicit Watcher(const std::string& text) {
        folder.write("a.toml", text);
        child = fork();
        if (child != 0) return;
        const int err = open(log.file("err").c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
        const bool ready = chdir(folder.path.c_str()) == 0 && dup2(err, STDERR_FILENO) == STDERR_FILENO;
        if (ready) execl(KREDA_PROGRAM, KREDA_PROGRAM, "render", "a.toml", "-o", "a.png", "--watch", nullptr);
        _exit(127);
    }
    ~Watcher() {
        if (child > 0) (void)end(SIGKILL);
    }
    [[nodiscard]] int end(int signal) {
        int status = 0;
        kill(child, signal);
        waitpid(child, &status, 0);
        child = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    }
    [[nodiscard]] std::string said() const {
        return bytes_of(log.file("err"));
    }
    /// The red, green and blue of the picture's first pixel; black where there is none.
    [[nodiscard]] glm::vec3 color() const {
        if (!std::filesystem::exists(folder.file("a.png"))) return glm::vec3(0.0f);
        return scene::read_image(folder.file("a.png")).rgb(0, 0);
    }
};

/// Does it come true before a minute is over? The machine may be busy.
bool comes(const std::function<bool()>& condition) {
    const auto begin = std::chrono::steady_clock::now();
    while (!condition()) {
        if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(60)) return false;
        usleep(5000);
    }
    return true;
}

bool is_color(const Watcher& watcher, const glm::vec3& color) {
    return comes([&] { return watcher.color() == color; });
}

constexpr glm::vec3 kPureRed{1.0f, 0.0f, 0.0f}, kPureGreen{0.0f, 1.0f, 0.0f}, kPureBlue{0.0f, 0.0f, 1.0f};

}  // namespace

TEST_CASE("watch: a saved scene is drawn, a broken one is one line, a mended one is drawn") {
    Watcher watcher(scene_of_color("[1, 0, 0]"));
    REQUIRE(is_color(watcher, kPureRed));
    watcher.folder.write("a.toml", scene_of_color("[0, 1, 0]"));
    CHECK(is_color(watcher, kPureGreen));
    watcher.folder.write("a.toml", scene_of_color("[0, 1"));
    CHECK(comes([&] { return watcher.said().find("a.toml:3:") != std::string::npos; }));
    CHECK(watcher.color() == kPureGreen);
    // As editors do it that save under another name first.
    watcher.folder.write("a.toml.new", scene_of_color("[0, 0, 1]"));
    std::filesystem::rename(watcher.folder.file("a.toml.new"), watcher.folder.file("a.toml"));
    CHECK(is_color(watcher, kPureBlue));
    CHECK(watcher.end(SIGINT) == 0);
    CHECK(names_in(watcher.folder.path.string()) == std::vector<std::string>{"a.png", "a.toml"});
    std::string said = watcher.said();
    CHECK(line_count(said) < 20);  // a few lines each time, and no more
}

TEST_CASE("watch: meshes and textures are watched, too, and one that is missing is drawn when it comes") {
    Watcher watcher("[image]\nsize = [32, 16]\n[ambient]\ncolor = [1, 1, 1]\n[camera]\nposition = [0, 0, 2]\n" +
                    std::string("[[material]]\nname = \"m\"\nmodel = \"unlit\"\ndiffuse = [1, 1, 1]\n") +
                    "diffuse_map = \"t.png\"\n[[object]]\nmesh = \"parts/a.obj\"\nmaterial = \"m\"\n");
    CHECK(comes([&] { return watcher.said().find("t.png") != std::string::npos; }));
    const auto save_texture = [&](const glm::vec3& color) {
        raster::Image image = raster::make_image(2, 2, 3);
        for (int i = 0; i < 4; ++i) image.set_rgb(i % 2, i / 2, color);
        scene::write_png(watcher.folder.file("t.png"), image);
    };
    save_texture(kPureRed);
    CHECK(comes([&] { return watcher.said().find("a.obj") != std::string::npos; }));
    const std::string corners = "v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nvt 0 0\n";
    watcher.folder.write("parts/a.obj", corners + "f 1/1 2/1 3/1 4/1\n");
    CHECK(is_color(watcher, kPureRed));
    save_texture(kPureBlue);
    CHECK(is_color(watcher, kPureBlue));
    watcher.folder.write("parts/a.obj", corners + "f 4/1 3/1 2/1 1/1\n");  // seen from behind
    CHECK(is_color(watcher, glm::vec3(0.0f)));
    CHECK(watcher.end(SIGTERM) == 0);
}

TEST_CASE("watch: without a file there is nothing to watch") {
    const TempFolder folder;
    for (const std::vector<std::string>& args :
         {std::vector<std::string>{"render", "--watch"}, {"render", "none.toml", "--watch"}}) {
        const Outcome outcome = run_kreda(args, folder.path.string());
        CHECK(outcome.exit_code == 2);
        CHECK(line_count(outcome.err) == 1);
        CHECK(outcome.err.find("--watch needs a scene file") != std::string::npos);
    }
}
