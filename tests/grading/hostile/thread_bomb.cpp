#include <pthread.h>
#include <unistd.h>
static void* wait_forever(void*) {
    for (;;) pause();
}
float attack() {
    pthread_attr_t small;
    pthread_attr_init(&small);
    pthread_attr_setstacksize(&small, 16384);
    pthread_t thread;
    int count = 0;
    while (count < 100000 && pthread_create(&thread, &small, wait_forever, nullptr) == 0) ++count;
    for (;;) pause();
}
