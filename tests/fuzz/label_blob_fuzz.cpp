#include "runtime/schema/label_blob.h"

#include <cstddef>
#include <cstdint>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  docent::LabelTable table;
  if (!docent::schema::decode(std::as_bytes(std::span(data, size)), table)) {
    if (!table.hub.empty()) __builtin_trap();
    return 0;
  }
  if (table.first.back() != table.hub.size()) __builtin_trap();
  // What was read can be written, and read again as the same.
  const auto written = docent::schema::encode(table);
  docent::LabelTable again;
  if (!docent::schema::decode(written, again)) __builtin_trap();
  if (docent::schema::encode(again) != written) __builtin_trap();
  return 0;
}
