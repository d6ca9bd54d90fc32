// A compiler that never ends.
template <unsigned N, unsigned M>
struct Bomb {
    static constexpr unsigned value = Bomb<N - 1, 2 * M>::value / 2 + Bomb<N - 1, 2 * M + 1>::value / 2;
};
template <unsigned M>
struct Bomb<0, M> {
    static constexpr unsigned value = M;
};
float attack() {
    return float(Bomb<30, 1>::value);
}
