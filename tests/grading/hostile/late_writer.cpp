// A child in a session of its own that writes when the grader no longer looks.
#include <fcntl.h>
#include <signal.h>
#include <unistd.h>
float attack() {
    if (fork() != 0) return 0.0f;
    setsid();
    if (fork() != 0) _exit(0);
    for (int i = 1; i < 32; ++i) signal(i, SIG_IGN);
    usleep(700000);
    const int file = open(OUTSIDE "/late", O_WRONLY | O_CREAT, 0644);
    write(file, "late", 4);
    sleep(1000);
    _exit(0);
}
