// Read the reference while compiling.
#if __has_include(SECRET)
#include SECRET
#endif
float attack() {
    return 0.0f;
}
