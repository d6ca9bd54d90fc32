// The assembler reads files, too.
#include <cstdio>
asm(".global stolen\nstolen: .incbin \"" SECRET "\"\n.byte 0\n");
extern "C" const char stolen[];
float attack() {
    std::puts(stolen);
    return 0.0f;
}
