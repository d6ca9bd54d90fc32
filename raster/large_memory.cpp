// Where large blocks of memory lie: films, buffers and vertex streams begin where a cache line does.
//
// Then a tile's rows in the film are whole lines: two threads never write to the same one (each would wait for the
// other), and they can be written past the cache (raster/copy_past_cache.hpp). glibc's malloc puts large blocks 16
// bytes off. A program may replace `operator new`; everything but the alignment stays as it was. A std::vector<float>
// with an allocator of its own would do the same, but it would be another type wherever an image meets plain numbers.
#include <cstddef>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

#if !defined(KREDA_SANITIZED)

namespace {

constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kLarge = 256 * 1024;
constexpr std::size_t kHugePage = 2 * 1024 * 1024;

std::size_t rounded_up(std::size_t size, std::size_t unit) {
    return (size + unit - 1) / unit * unit;
}

/// Ask for large pages where several fit: scattered reads of vertices then miss the page table less often.
void* allocate_huge(std::size_t size) {
    void* const memory = std::aligned_alloc(kHugePage, rounded_up(size, kHugePage));
#if defined(__linux__)
    if (memory) madvise(memory, size, MADV_HUGEPAGE);
#endif
    return memory;
}

void* allocate(std::size_t size) {
    if (size < kLarge) return std::malloc(size > 0 ? size : 1);
    if (size < 2 * kHugePage) return std::aligned_alloc(kCacheLine, rounded_up(size, kCacheLine));
    return allocate_huge(size);
}

}  // namespace

void* operator new(std::size_t size) {
    while (true) {
        if (void* const memory = allocate(size)) return memory;
        const std::new_handler handler = std::get_new_handler();
        if (!handler) throw std::bad_alloc();
        handler();
    }
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

#endif
