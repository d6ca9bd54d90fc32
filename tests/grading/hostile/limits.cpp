// Raise one's own limits, lower the grader's.
#include <sys/resource.h>
#include <unistd.h>
#include <cstdio>
#include <initializer_list>
float attack() {
    const rlimit most{RLIM_INFINITY, RLIM_INFINITY}, least{0, 0};
    for (const int resource : {RLIMIT_CPU, RLIMIT_AS, RLIMIT_FSIZE, RLIMIT_NPROC}) {
        if (setrlimit(static_cast<__rlimit_resource>(resource), &most) == 0) std::puts("leak: raised");
    }
    if (prlimit(getppid(), RLIMIT_NOFILE, &least, nullptr) == 0) std::puts("leak: lowered the grader's");
    if (setpriority(PRIO_PROCESS, 0, -20) == 0) std::puts("leak: faster");
    std::fflush(stdout);
    return 0.0f;
}
