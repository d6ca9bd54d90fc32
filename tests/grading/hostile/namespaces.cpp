// Become root in a namespace of one's own and mount something.
#include <sched.h>
#include <sys/mount.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cstdio>
float attack() {
    if (unshare(CLONE_NEWUSER | CLONE_NEWNS) == 0) std::puts("leak: unshare");
    if (mount("none", ".", "tmpfs", 0, nullptr) == 0) std::puts("leak: mount");
    if (syscall(SYS_clone, CLONE_NEWUSER | 17, 0, 0, 0, 0) >= 0) std::puts("leak: clone");
    if (setuid(0) == 0 && getuid() == 0) std::puts("leak: root");
    std::fflush(stdout);
    return 0.0f;
}
