#include "tests/support/reference_data.h"

namespace docent::test {

std::filesystem::path reference_data() {
  return DOCENT_REFERENCE_DATA;
}
std::filesystem::path source_dir() {
  return DOCENT_SOURCE_DIR;
}
std::filesystem::path program(const char* name) {
  return std::filesystem::path(DOCENT_BINARY_DIR) / name;
}

}  // namespace docent::test
