// 10 GB on the standard output.
#include <unistd.h>
#include <cstring>
static char part[1 << 16];
float attack() {
    std::memset(part, 'x', sizeof part);
    for (long written = 0; written < 10000000000; written += sizeof part) {
        if (write(1, part, sizeof part) < 0) break;
    }
    return 0.0f;
}
