// Memory that no limit counts and that stays.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/msg.h>
#include <sys/shm.h>
#include <unistd.h>
#include <cstdio>
float attack() {
    if (shmget(0x6b7265, 1 << 20, IPC_CREAT | 0666) >= 0) std::puts("leak: shmget");
    if (msgget(0x6b7265, IPC_CREAT | 0666) >= 0) std::puts("leak: msgget");
    if (memfd_create("x", 0) >= 0) std::puts("leak: memfd");
    if (shm_open("/kreda_hostile", O_CREAT | O_RDWR, 0666) >= 0) std::puts("leak: shm_open");
    std::fflush(stdout);
    return 0.0f;
}
