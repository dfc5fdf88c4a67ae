// The program of one target: CMake names it in REMESHD_FUZZ_TARGET.
#include <google/protobuf/stubs/logging.h>

#include "tests/fuzz/targets.h"

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  // Protobuf would tell of every text that is no UTF-8.
  google::protobuf::SetLogHandler(nullptr);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return REMESHD_FUZZ_TARGET(data, size);
}
