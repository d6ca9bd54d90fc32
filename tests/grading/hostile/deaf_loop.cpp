// Ignores every signal that can be ignored.
#include <signal.h>
float attack() {
    for (int i = 1; i < 65; ++i) signal(i, SIG_IGN);
    for (volatile int i = 0;; i = i + 1) {}
}
