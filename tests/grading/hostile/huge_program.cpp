// A program file of gigabytes.
static char a[3u << 30] = {1};
float attack() {
    return float(a[12345]);
}
