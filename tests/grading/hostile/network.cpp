#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>
#include <cstdio>
#include <cstring>
float attack() {
    if (socket(AF_INET, SOCK_STREAM, 0) >= 0) std::puts("leak: inet");
    if (socket(AF_INET6, SOCK_DGRAM, 0) >= 0) std::puts("leak: inet6");
    if (socket(AF_UNIX, SOCK_STREAM, 0) >= 0) std::puts("leak: unix");
    if (socket(AF_NETLINK, SOCK_RAW, 0) >= 0) std::puts("leak: netlink");
    std::fflush(stdout);
    return 0.0f;
}
