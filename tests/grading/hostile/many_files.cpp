#include <fcntl.h>
#include <unistd.h>
#include <cstdio>
float attack() {
    for (int i = 0; i < 1000000; ++i) {
        char name[32];
        std::snprintf(name, sizeof name, "n%d", i);
        close(open(name, O_WRONLY | O_CREAT, 0644));
    }
    return 0.0f;
}
