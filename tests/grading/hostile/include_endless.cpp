// A file without an end.
#include "/dev/zero"
float attack() {
    return 0.0f;
}
