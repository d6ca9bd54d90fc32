// System calls by their 32-bit numbers, which filters forget.
#include <unistd.h>
#include <cstdio>
float attack() {
#if defined(__x86_64__)
    long result = 20;  // getpid of i386
    asm volatile("int $0x80" : "+a"(result) : : "memory");
    if (result == getpid()) std::puts("leak: int 0x80");
    long x32 = 0x40000000 + 39;  // getpid of x32
    asm volatile("syscall" : "+a"(x32) : : "rcx", "r11", "memory");
    if (x32 == getpid()) std::puts("leak: x32");
    std::fflush(stdout);
#endif
    return 0.0f;
}
