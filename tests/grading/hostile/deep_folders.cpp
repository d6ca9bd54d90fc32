// A path longer than paths can be, closed at its end.
#include <sys/stat.h>
#include <unistd.h>
float attack() {
    for (int i = 0; i < 3000; ++i) {
        if (mkdir("dddddddddddddddddddddddd", 0755) != 0 || chdir("dddddddddddddddddddddddd") != 0) break;
    }
    return 0.0f;
}
