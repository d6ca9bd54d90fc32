// Memory that this test program has asked for and not given back: counted by its own operator new.
#pragma once

#include <cstdint>

namespace kreda::tests {

/// Bytes, as asked for; always 0 where a sanitizer counts for itself.
[[nodiscard]] std::int64_t bytes_in_use();

}  // namespace kreda::tests
