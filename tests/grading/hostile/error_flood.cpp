// Megabytes of complaints.
#define X10(x) x x x x x x x x x x
#define X1000(x) X10(X10(X10(x)))
#pragma GCC diagnostic warning "-Wall"
int f() {
    X10(X1000(undeclared_thing_with_a_long_name();)) return 0;
}
float attack() {
    return float(f());
}
