#include "raster/aligned_vector.hpp"

#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace kreda::raster {

namespace {

constexpr std::size_t kHugePage = 2 * 1024 * 1024;

std::align_val_t unit_of(std::size_t bytes) {
    return std::align_val_t(bytes < 2 * kHugePage ? kCacheLine : kHugePage);
}

}  // namespace

void* allocate_aligned(std::size_t bytes) {
    const std::align_val_t unit = unit_of(bytes);
    void* const memory = ::operator new(bytes, unit);
#if defined(__linux__)
    if (unit == std::align_val_t(kHugePage)) madvise(memory, bytes, MADV_HUGEPAGE);
#endif
    return memory;
}

void free_aligned(void* memory, std::size_t bytes) noexcept {
    ::operator delete(memory, unit_of(bytes));
}

}  // namespace kreda::raster
