#include <cstddef>
#include <cstdint>
#include <string>

#include "config/toml_document.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const docent::config::TomlFile file = docent::config::parse_toml(text, "fuzz.toml");
  if (file.root.has_value() != file.diagnostics.empty()) __builtin_trap();
  return 0;
}
