// OpenMP where there is one; else the only thread.
#pragma once

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace kreda::scene {

inline int thread_count() {
#if defined(_OPENMP)
    return omp_get_max_threads();
#else
    return 1;
#endif
}

inline int thread_number() {
#if defined(_OPENMP)
    return omp_get_thread_num();
#else
    return 0;
#endif
}

/// Sets the number of threads for the length of a frame; 0: as many as there are cores.
class ThreadLimit {
public:
    explicit ThreadLimit(int threads) : before_(thread_count()) {
        set(threads > 0 ? threads : before_);
    }
    ~ThreadLimit() {
        set(before_);
    }
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    static void set([[maybe_unused]] int threads) {
#if defined(_OPENMP)
        omp_set_num_threads(threads);
#endif
    }
    int before_;
};

}  // namespace kreda::scene
