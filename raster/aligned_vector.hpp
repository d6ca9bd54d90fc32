// Memory for films, buffers and vertex streams: a std::vector that begins where a cache line does.
//
// Then a tile's rows in the film are whole lines: two threads never write to the same one (each would wait for the
// other), and they can be written past the cache (raster/copy_past_cache.hpp). glibc's malloc puts large blocks 16
// bytes off.
#pragma once

#include <cstddef>
#include <vector>

namespace kreda::raster {

/// Bytes of a cache line on every x86 and most ARM processors.
inline constexpr std::size_t kCacheLine = 64;

/// At least `bytes` bytes from the start of a cache line; of several huge pages' size, huge pages where the system has
/// them: scattered reads of vertices then miss the page table less often. Throws std::bad_alloc.
[[nodiscard]] void* allocate_aligned(std::size_t bytes);
/// Give it back; as many bytes as were asked for.
void free_aligned(void* memory, std::size_t bytes) noexcept;

/// What std::vector asks for its memory. All of them are alike: one frees what another gave.
template <typename T>
struct AlignedAllocator {
    using value_type = T;  ///< of the vector

    AlignedAllocator() = default;
    /// std::vector makes allocators of other types from this one.
    template <typename U>
    AlignedAllocator(const AlignedAllocator<U>&) noexcept {}

    /// Room for so many values.
    [[nodiscard]] T* allocate(std::size_t count) {
        return static_cast<T*>(allocate_aligned(count * sizeof(T)));
    }
    /// Give back what allocate(count) gave.
    void deallocate(T* memory, std::size_t count) noexcept {
        free_aligned(memory, count * sizeof(T));
    }
    /// Always true.
    bool operator==(const AlignedAllocator&) const = default;
};

/// A std::vector that begins with a cache line.
template <typename T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace kreda::raster
