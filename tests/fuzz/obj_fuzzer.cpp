// libFuzzer over the OBJ reader. Built with -DZSCOPE_FUZZ=ON and clang:
//     cmake --build build --target obj_fuzzer && build/tests/fuzz/obj_fuzzer tests/fuzz/obj_seeds -max_total_time=600

#include <cstddef>
#include <cstdint>

#include "tests/fuzz/obj_target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    zscope::fuzz::readAsObj({reinterpret_cast<const char*>(data), size});
    return 0;
}
