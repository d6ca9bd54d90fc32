// Waits without using the processor.
#include <unistd.h>
float attack() {
    for (;;) sleep(1000);
}
