// What Kreda calls of OpenMP's library, for the module with threads (web_openmp.cpp beside this file).
#pragma once

extern "C" {
int omp_get_max_threads();
int omp_get_thread_num();
void omp_set_num_threads(int threads);
/// How many threads fetched a piece of a loop since this was called before; not OpenMP's.
int kreda_threads_at_work();
}
