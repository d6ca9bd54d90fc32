// Memory that this test program has asked for and not given back: counted by its own operator new.
#pragma once

#include <cstdint>

namespace kreda::tests {

/// Bytes, as asked for; always 0 where a sanitizer counts for itself.
[[nodiscard]] std::int64_t bytes_in_use();

/// The most that was in use at once since most_bytes_since() was called before.
[[nodiscard]] std::int64_t most_bytes_since();

}  // namespace kreda::tests
