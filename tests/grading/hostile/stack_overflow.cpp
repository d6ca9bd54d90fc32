__attribute__((noinline)) static float deeper(volatile float* from) {
    volatile float here[1024];
    here[0] = *from + 1.0f;
    return deeper(here) + here[0];
}
float attack() {
    volatile float zero = 0.0f;
    return deeper(&zero);
}
