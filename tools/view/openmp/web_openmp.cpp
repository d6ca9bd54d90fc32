// OpenMP for the module with threads: what clang makes of `#pragma omp` calls a library, which Debian has for
// processors and not for browsers. Here is as much of it as Kreda's pragmas need: parallel regions, loops (static and
// dynamic), barriers, critical sections, reductions. Threads are Web Workers, made when the module starts
// (PTHREAD_POOL_SIZE).
//
// The names and signatures are those of LLVM's runtime ("LLVM OpenMP Runtime Library Interface", kmp.h). A region
// inside a region runs in one thread, as OpenMP has it by default. Nothing here may throw into the caller: OpenMP
// forbids it, too.
#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "tools/view/openmp/omp.h"
#include "tools/view/openmp/team.hpp"

#if !defined(__EMSCRIPTEN__)
#error "a program has an OpenMP of its own, whose functions these would replace"
#endif

namespace {

using namespace kreda::openmp;

int wanted_threads = 0;                        ///< 0: one a core
std::recursive_mutex critical_section;         ///< one for all names: nothing of ours holds two
thread_local std::vector<Place> outer_places;  ///< while a region runs in the thread that came to it

}  // namespace

extern "C" {

// clang asks the linker for one of these a name of a critical section, in a way (common symbols) that WebAssembly's
// lacks.
std::int32_t critical_without_name[8] __asm__(".gomp_critical_user_.var");
std::int32_t critical_progress[8] __asm__(".gomp_critical_user_kreda_progress.var");
std::int32_t critical_reduction[8] __asm__(".gomp_critical_user_.reduction.var");

int omp_get_max_threads() {
    return wanted_threads > 0 ? wanted_threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

int omp_get_thread_num() {
    return place.number;
}

void omp_set_num_threads(int threads) {
    wanted_threads = std::max(threads, 1);
}

int kreda_threads_at_work() {
    return __builtin_popcountll(at_work.exchange(0));
}

void __kmpc_fork_call(void*, std::int32_t count, Body body, ...) {
    std::vector<void*> arguments(static_cast<std::size_t>(count));
    va_list list;
    va_start(list, body);
    for (void*& argument : arguments) argument = va_arg(list, void*);
    va_end(list);
    Team team(place.team ? 1 : omp_get_max_threads());
    if (team.size > 1) return pool().run(team, body, arguments);
    const Place outer = std::exchange(place, Place{&team, 0});
    call(body, 0, arguments);
    place = outer;
}

std::int32_t __kmpc_global_thread_num(void*) {
    return place.number;
}

/// A region whose `if` is false: the caller runs its body by itself.
void __kmpc_serialized_parallel(void*, std::int32_t) {
    outer_places.push_back(place);
    place = Place{new Team(1), 0};
}

void __kmpc_end_serialized_parallel(void*, std::int32_t) {
    delete place.team;
    place = outer_places.back();
    outer_places.pop_back();
}

void __kmpc_for_static_init_4(void*, std::int32_t, std::int32_t, std::int32_t* is_last, std::int32_t* lower,
                              std::int32_t* upper, std::int32_t*, std::int32_t step, std::int32_t) {
    static_stretch(is_last, lower, upper, step);
}

void __kmpc_for_static_init_4u(void*, std::int32_t, std::int32_t, std::int32_t* is_last, std::uint32_t* lower,
                               std::uint32_t* upper, std::int32_t*, std::int32_t step, std::int32_t) {
    static_stretch(is_last, lower, upper, step);
}

void __kmpc_for_static_fini(void*, std::int32_t) {}

void __kmpc_dispatch_init_4(void*, std::int32_t, std::int32_t, std::int32_t first, std::int32_t last, std::int32_t step,
                            std::int32_t chunk) {
    begin_loop(first, last, step, chunk);
}

void __kmpc_dispatch_init_4u(void*, std::int32_t, std::int32_t, std::uint32_t first, std::uint32_t last,
                             std::int32_t step, std::int32_t chunk) {
    begin_loop(first, last, step, chunk);
}

int __kmpc_dispatch_next_4(void*, std::int32_t, std::int32_t* is_last, std::int32_t* lower, std::int32_t* upper,
                           std::int32_t* stride) {
    return next_piece(is_last, lower, upper, stride);
}

int __kmpc_dispatch_next_4u(void*, std::int32_t, std::int32_t* is_last, std::uint32_t* lower, std::uint32_t* upper,
                            std::int32_t* stride) {
    return next_piece(is_last, lower, upper, stride);
}

void __kmpc_barrier(void*, std::int32_t) {
    Team& team = *place.team;
    std::unique_lock lock(team.mutex);
    const std::uint64_t mine = team.barriers;
    if (++team.waiting == team.size) {
        team.waiting = 0;
        ++team.barriers;
        team.changed.notify_all();
    } else {
        team.changed.wait(lock, [&] { return team.barriers != mine; });
    }
}

void __kmpc_critical(void*, std::int32_t, void*) {
    critical_section.lock();
}

void __kmpc_end_critical(void*, std::int32_t, void*) {
    critical_section.unlock();
}

/// 1: the thread adds its part itself, one thread at a time.
std::int32_t __kmpc_reduce_nowait(void*, std::int32_t, std::int32_t, std::size_t, void*, void (*)(void*, void*),
                                  void*) {
    critical_section.lock();
    return 1;
}

void __kmpc_end_reduce_nowait(void*, std::int32_t, void*) {
    critical_section.unlock();
}

}  // extern "C"
