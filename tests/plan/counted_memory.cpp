#include "tests/plan/counted_memory.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<std::int64_t> in_use{0}, peak{0};

}  // namespace

std::int64_t kreda::tests::bytes_in_use() {
    return in_use.load();
}

std::int64_t kreda::tests::most_bytes_since() {
    return peak.exchange(in_use.load());
}

#if !defined(KREDA_SANITIZED)

namespace {

/// Before each block stands its size, in a line of the block's alignment.
void* take(std::size_t size, std::size_t alignment) {
    const std::size_t line = alignment < 16 ? 16 : alignment;
    void* const block = std::aligned_alloc(line, (size + line + line - 1) / line * line);
    if (!block) throw std::bad_alloc();
    *static_cast<std::size_t*>(block) = size;
    const std::int64_t now = in_use += static_cast<std::int64_t>(size);
    for (std::int64_t before = peak; before < now && !peak.compare_exchange_weak(before, now);) {}
    return static_cast<char*>(block) + line;
}

void give_back(void* memory, std::size_t alignment) {
    if (!memory) return;
    void* const block = static_cast<char*>(memory) - (alignment < 16 ? 16 : alignment);
    in_use -= static_cast<std::int64_t>(*static_cast<std::size_t*>(block));
    std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
    return take(size, 16);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return take(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    give_back(memory, 16);
}
void operator delete(void* memory, std::size_t) noexcept {
    give_back(memory, 16);
}
void operator delete(void* memory, std::align_val_t alignment) noexcept {
    give_back(memory, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory, std::size_t, std::align_val_t alignment) noexcept {
    give_back(memory, static_cast<std::size_t>(alignment));
}

#endif
