#include <cstddef>
#include <cstdint>

#include "content/import/drawing/svg.h"
#include "tests/fuzz/building_bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  docent::test::expect_rooms_or_sentence(data, size, "fuzz.svg", [](const auto& source) {
    return docent::import::read_svg(source, {.unit = "m"});
  });
  return 0;
}
