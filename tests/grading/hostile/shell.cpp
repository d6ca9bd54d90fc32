// Let other programs do it.
#include <unistd.h>
#include <cstdlib>
float attack() {
    std::system("cat " SECRET "; cp " SECRET " outputs.bin; id > " OUTSIDE "/id; (setsid sleep 1000 &)");
    execl("/bin/sh", "sh", "-c", "read -r x < " SECRET " && echo \"leak: $x\"; echo y > " OUTSIDE "/y", nullptr);
    return 0.0f;
}
