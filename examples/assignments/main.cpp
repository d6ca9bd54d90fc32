// The program around a student's functions: see harness.hpp.
#include "harness.hpp"

void run_row(harness::Row row);  // the assignment's stages.cpp

int main(int argc, char** argv) {
    if (argc < 3) return 2;
    harness::run_tables(harness::read_tables(argv[1]), run_row, argv[2], argc > 3 ? argv[3] : "");
    return 0;
}
