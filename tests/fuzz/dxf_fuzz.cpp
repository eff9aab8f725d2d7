#include <cstddef>
#include <cstdint>

#include "content/import/drawing/read_drawing.h"
#include "tests/fuzz/building_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  docent::test::expect_rooms_or_sentence(data, size, "fuzz.dxf", [](const auto& source) {
    return docent::import::read_dxf(source, {.unit = "m"});
  });
  return 0;
}
