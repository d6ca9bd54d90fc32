// Read and write the memory of the process above.
#include <sys/ptrace.h>
#include <sys/uio.h>
#include <unistd.h>
#include <cstdio>
float attack() {
    char text[64];
    iovec here{text, sizeof text}, there{reinterpret_cast<void*>(0x400000), sizeof text};
    if (ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr) == 0) std::puts("leak: ptrace");
    if (process_vm_readv(getppid(), &here, 1, &there, 1, 0) > 0) std::puts("leak: memory");
    char name[64];
    std::snprintf(name, sizeof name, "/proc/%d/mem", getppid());
    if (std::fopen(name, "r")) std::puts("leak: mem");
    std::fflush(stdout);
    return 0.0f;
}
