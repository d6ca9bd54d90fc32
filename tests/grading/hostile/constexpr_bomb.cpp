// The same with constant expressions.
constexpr int spin(int n, int seed) {
    return n < 2 ? n + seed : spin(n - 1, seed) + spin(n - 2, seed + 1) % 5;
}
template <int N>
struct More {
    static constexpr int value = spin(22, 100 * N) % 7 + More<N - 1>::value % 7;
};
template <>
struct More<0> {
    static constexpr int value = 0;
};
float attack() {
    return float(More<800>::value);
}
