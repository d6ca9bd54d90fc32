#include "tests/tools/run_kreda.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/scene/temp_folder.hpp"

namespace kreda::tests {

namespace {

/// In the child process: become the program. Never returns.
[[noreturn]] void become_program(char** arguments, const char* folder, const char* out, const char* err) {
    const int out_file = open(out, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const int err_file = open(err, O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const bool ready =
        out_file >= 0 && err_file >= 0 && chdir(folder) == 0 && dup2(out_file, 1) == 1 && dup2(err_file, 2) == 2;
    if (ready) execv(arguments[0], arguments);
    _exit(127);
}

}  // namespace

Outcome run_kreda(const std::vector<std::string>& args, const std::string& folder) {
    return run_program(KREDA_PROGRAM, args, folder);
}

Outcome run_program(const std::string& program, const std::vector<std::string>& args, const std::string& folder) {
    const TempFolder log;
    const std::string out = log.file("out"), err = log.file("err");
    std::vector<std::string> words{program};
    words.insert(words.end(), args.begin(), args.end());
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);

    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("fork failed");
    if (child == 0) become_program(arguments.data(), folder.c_str(), out.c_str(), err.c_str());
    int status = 0;
    waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return {code, bytes_of(out), bytes_of(err)};
}

int line_count(const std::string& text) {
    const bool open_end = !text.empty() && text.back() != '\n';
    return static_cast<int>(std::count(text.begin(), text.end(), '\n')) + (open_end ? 1 : 0);
}

std::vector<std::string> names_in(const std::string& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace kreda::tests
