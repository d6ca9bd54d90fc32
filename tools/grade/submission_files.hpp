// The files of a submission, as what is to be graded and told apart.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kreda::tools {

/// A name for the contents of a folder (or a file): equal for equal files with equal names below it, 32 hexadecimal
/// digits. Links are not followed, hidden files left out; files above 16 MB count by their size.
[[nodiscard]] std::string content_of(const std::filesystem::path& folder);

/// The folders in a class's folder, sorted; hidden ones are left out. Throws UserError where there are none.
[[nodiscard]] std::vector<std::string> submissions_in(const std::filesystem::path& folder);

/// A name in a link: what a URL does not take is written as %XX.    RFC 3986, section 2.1
[[nodiscard]] std::string link_of(const std::string& name);

/// Remove the box folders in the system's temporary folder that killed graders of this user left behind.
void remove_stale_box_folders();

}  // namespace kreda::tools
