#include <cstddef>
#include <cstdint>

#include "content/import/ifc/ifc.h"
#include "tests/fuzz/building_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  docent::test::expect_rooms_or_sentence(data, size, "fuzz.ifc", [](const auto& source) {
    return docent::import::read_ifc(source, {.unit = "m"});
  });
  return 0;
}
