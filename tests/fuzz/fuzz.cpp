// libFuzzer's program: KREDA_FUZZED names the reader, KREDA_FUZZ_FOLDER a folder to write its files into.
//   KREDA_FUZZED=obj KREDA_FUZZ_FOLDER=/dev/shm build/fuzz/bin/fuzz -max_total_time=60 corpus tests/fuzz/seeds/obj
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "tests/fuzz/readers.hpp"

namespace {

const kreda::tests::FuzzedReader& chosen_reader() {
    const char* const name = std::getenv("KREDA_FUZZED");
    for (const kreda::tests::FuzzedReader& reader : kreda::tests::fuzzed_readers()) {
        if (name && reader.name == name) return reader;
    }
    std::fputs("fuzz: KREDA_FUZZED must be scene, obj, mtl, gltf or image\n", stderr);
    std::exit(2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const kreda::tests::FuzzedReader& reader = chosen_reader();
    static const char* const folder = std::getenv("KREDA_FUZZ_FOLDER");
    reader.read(std::string(reinterpret_cast<const char*>(bytes), size), folder ? folder : ".");
    return 0;
}
