// A region's threads, the loops that they share, and the pool that they come from: what web_openmp.cpp hands to clang.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace kreda::openmp {

constexpr std::size_t kLoopsUnderWay = 8;  ///< loops without a wait at their end that a thread may be ahead of another
constexpr int kMostArguments = 24;         ///< variables that a region shares with its surroundings

/// A loop whose iterations threads fetch. `number` says which loop of the region it serves at the moment.
struct SharedLoop {
    std::uint64_t number;
    std::int64_t next;  ///< iteration to be fetched next, from 0
    int finished;       ///< threads that found nothing left
};

/// The threads of one region and what they share.
struct Team {
    int size = 1;
    std::mutex mutex;
    std::condition_variable changed;
    int waiting = 0;             ///< at the barrier
    std::uint64_t barriers = 0;  ///< that all have passed
    std::array<SharedLoop, kLoopsUnderWay> loops{};

    explicit Team(int threads) : size(threads) {
        for (std::size_t i = 0; i < kLoopsUnderWay; ++i) loops[i].number = i;
    }
};

/// A thread's place in its team and the loop that it is in.
struct Place {
    Team* team = nullptr;  ///< none outside of regions
    std::int32_t number = 0;
    std::uint64_t loops_begun = 0;
    std::int64_t first = 0, count = 0, step = 1, chunk = 1;
};

inline thread_local Place place;

/// The function that clang makes of a region's body.
using Body = void (*)(std::int32_t*, std::int32_t*, ...);

template <std::size_t>
using Pointer = void*;

/// WebAssembly calls a function only by its very signature: here with one pointer for each index.
template <std::size_t... Index>
void call_with(Body body, std::int32_t number, void* const* arguments, std::index_sequence<Index...>) {
    std::int32_t global = number, bound = number;
    (void)arguments;
    reinterpret_cast<void (*)(std::int32_t*, std::int32_t*, Pointer<Index>...)>(body)(&global, &bound,
                                                                                      arguments[Index]...);
}

template <std::size_t... Count>
void call_one_of(Body body, std::int32_t number, const std::vector<void*>& arguments, std::index_sequence<Count...>) {
    ((arguments.size() == Count ? call_with(body, number, arguments.data(), std::make_index_sequence<Count>())
                                : void()),
     ...);
}

inline void call(Body body, std::int32_t number, const std::vector<void*>& arguments) {
    if (arguments.size() >= kMostArguments) __builtin_trap();
    call_one_of(body, number, arguments, std::make_index_sequence<kMostArguments>());
}

/// Threads that wait for regions. The first is the caller's, which is none of these.
class Pool {
public:
    /// Run body(number, arguments) in `size` threads, this one included, and wait for all.
    void run(Team& team, Body body, const std::vector<void*>& arguments) {
        {
            const std::lock_guard lock(mutex_);
            while (static_cast<int>(threads_.size()) + 1 < team.size) {
                threads_.emplace_back([this, number = static_cast<int>(threads_.size()) + 1] { serve(number); });
            }
            team_ = &team;
            size_ = team.size;
            body_ = body;
            arguments_ = &arguments;
            busy_ = team.size - 1;
            ++regions_;
        }
        called_.notify_all();
        take_part(0, team, body, arguments);
        std::unique_lock lock(mutex_);
        done_.wait(lock, [this] { return busy_ == 0; });
    }

private:
    std::mutex mutex_;
    std::condition_variable called_, done_;
    std::vector<std::thread> threads_;
    Team* team_ = nullptr;
    int size_ = 0;  ///< of the team, which may be gone when a thread wakes that has no part in it
    Body body_ = nullptr;
    const std::vector<void*>* arguments_ = nullptr;
    int busy_ = 0;
    std::uint64_t regions_ = 0;

    static void take_part(int number, Team& team, Body body, const std::vector<void*>& arguments) {
        const Place outer = std::exchange(place, Place{&team, number});
        call(body, number, arguments);
        place = outer;
    }

    [[noreturn]] void serve(int number) {
        std::unique_lock lock(mutex_);
        std::uint64_t seen = 0;
        while (true) {
            called_.wait(lock, [&] { return regions_ != seen; });
            seen = regions_;
            if (number >= size_) continue;
            Team& team = *team_;
            const Body body = body_;
            const std::vector<void*>& arguments = *arguments_;
            lock.unlock();
            take_part(number, team, body, arguments);
            lock.lock();
            if (--busy_ == 0) done_.notify_all();
        }
    }
};

inline Pool& pool() {
    static Pool* const threads = new Pool;  // never ended: its threads are the browser's to end
    return *threads;
}

/// A bit for each thread that fetched a piece of a loop since somebody looked; threads from 63 on share the last.
inline std::atomic<std::uint64_t> at_work{0};

inline SharedLoop& loop_of(const Place& mine) {
    return mine.team->loops[(mine.loops_begun - 1) % kLoopsUnderWay];
}

/// Begin a loop over first, first + step, ... `count` numbers in pieces of `chunk`.
inline void begin_loop(std::int64_t first, std::int64_t last, std::int64_t step, std::int64_t chunk) {
    const std::int64_t span = step > 0 ? last - first : first - last;
    place.first = first;
    place.count = span < 0 ? 0 : span / (step > 0 ? step : -step) + 1;
    place.step = step;
    place.chunk = std::max<std::int64_t>(chunk, 1);
    ++place.loops_begun;
    std::unique_lock lock(place.team->mutex);
    place.team->changed.wait(lock, [] { return loop_of(place).number == place.loops_begun - 1; });
}

/// The next piece of the loop, or false when nothing is left; the last thread frees the loop's place for another.
inline bool fetch_piece(std::int64_t& from, std::int64_t& to) {
    Team& team = *place.team;
    const std::lock_guard lock(team.mutex);
    SharedLoop& loop = loop_of(place);
    if (loop.next < place.count) {
        from = loop.next;
        to = std::min(loop.next + place.chunk, place.count) - 1;
        loop.next = to + 1;
        at_work |= std::uint64_t(1) << std::min(place.number, 63);
        return true;
    }
    if (++loop.finished == team.size) {
        loop = {loop.number + kLoopsUnderWay, 0, 0};
        team.changed.notify_all();
    }
    return false;
}

template <class Number>
int next_piece(std::int32_t* is_last, Number* lower, Number* upper, std::make_signed_t<Number>* stride) {
    std::int64_t from = 0, to = 0;
    if (!fetch_piece(from, to)) return 0;
    *is_last = to + 1 == place.count;
    *lower = static_cast<Number>(place.first + from * place.step);
    *upper = static_cast<Number>(place.first + to * place.step);
    *stride = static_cast<std::make_signed_t<Number>>(place.step);
    return 1;
}

/// A static loop: the numbers in as many equal stretches as threads, in their order.
template <class Number>
void static_stretch(std::int32_t* is_last, Number* lower, Number* upper, std::int64_t step) {
    const std::int64_t first = *lower, span = step > 0 ? *upper - first : first - *upper;
    const std::int64_t count = span < 0 ? 0 : span / (step > 0 ? step : -step) + 1;
    const std::int64_t size = place.team->size;
    const std::int64_t from = count * place.number / size, to = count * (place.number + 1) / size;
    *is_last = to == count && from < to;
    *lower = static_cast<Number>(first + (from < to ? from : count) * step);  // behind the end: nothing to do
    *upper = static_cast<Number>(first + ((from < to ? to : count) - 1) * step);
}

}  // namespace kreda::openmp
