// The box: a student's program, and the compiler that reads a student's file, run where they can do no harm.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace kreda::tools {

/// What a boxed command may use. All limits hold for every tier.
struct BoxLimits {
    double cpu_seconds = 10.0;                             ///< of each process
    double wall_seconds = 20.0;                            ///< from start to end
    std::uint64_t memory_bytes = std::uint64_t(1) << 30;   ///< of each process
    std::uint64_t output_bytes = std::uint64_t(64) << 20;  ///< all files in the work folder; and again stdout + stderr
    int processes = 1;  ///< 1: the command may start threads but no process; a compiler needs about 16
};

/// How strong the box is. bubblewrap: namespaces, nothing but system libraries, `readable` and `work` exists inside.
/// landlock: Landlock, seccomp, rlimits and, for root, an unprivileged uid; other files exist but cannot be opened.
/// unsafe: limits alone.
enum class BoxTier { bubblewrap, landlock, unsafe };

struct BoxRequest {
    std::vector<std::string> command;             ///< argv inside of the box; [0] with its whole path
    std::vector<std::filesystem::path> readable;  ///< files or folders, read-only, at the same path; system libraries,
                                                  ///< compilers and /usr/include always are readable
    std::filesystem::path work;                   ///< the one writable folder, current inside; see BoxFolder
    BoxLimits limits;
    std::optional<BoxTier> tier;  ///< this one or none; empty: the strongest that works here
};

struct BoxOutcome {
    enum class End { exited, signalled, timed_out, too_much_output, could_not_start };
    End end = End::could_not_start;
    int code = 0;          ///< exit code or signal
    std::string out, err;  ///< what it printed, together at most limits.output_bytes; err also says why it could not
                           ///< start
    double cpu_seconds = 0.0;
    double wall_seconds = 0.0;
    BoxTier tier = BoxTier::unsafe;
};

/// Run the command to its end or its limits; afterwards none of its processes lives. The environment inside is always
/// the same: PATH, HOME and TMPDIR (the work folder), LANG=C.UTF-8. Throws UserError where no tier works and
/// `allow_unsafe` is false. For root the folders that `work` and `readable` lie in must be open to others (x).
[[nodiscard]] BoxOutcome run_in_box(const BoxRequest& request, bool allow_unsafe);

/// The strongest tier that works here, tried once a process; empty: none but unsafe.
[[nodiscard]] std::optional<BoxTier> strongest_tier();

/// "bubblewrap", "landlock", "unsafe"
[[nodiscard]] std::string name_of(BoxTier tier);

/// "ended with exit code 3", "was ended by signal 11 (Segmentation fault)", "took longer than 10 s", ...; needs the
/// limits to name.
[[nodiscard]] std::string describe(const BoxOutcome& outcome, const BoxLimits& limits);

/// A new folder for boxed work in the system's temporary folder, which goes away with the object, whatever a student's
/// program left in it. Put all that a box reads there as well.
class BoxFolder {
public:
    BoxFolder();
    ~BoxFolder();
    BoxFolder(const BoxFolder&) = delete;
    BoxFolder& operator=(const BoxFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const {
        return path_;
    }

private:
    std::filesystem::path path_;
};

}  // namespace kreda::tools
