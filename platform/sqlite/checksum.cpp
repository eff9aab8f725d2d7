#include "platform/sqlite/checksum.h"

#include <sodium/crypto_generichash.h>

#include <algorithm>
#include <functional>

namespace docent::sqlite {

namespace {

void update(crypto_generichash_state& state, std::span<const std::byte> bytes) {
  crypto_generichash_update(&state, reinterpret_cast<const unsigned char*>(bytes.data()),
                            bytes.size());
}

}  // namespace

Checksum checksum_of(std::span<const std::byte> file, std::size_t place) {
  Checksum sum{};
  crypto_generichash_state state;
  crypto_generichash_init(&state, nullptr, 0, sum.size());
  update(state, file.first(place));
  update(state, sum);  // still zero
  update(state, file.subspan(place + sum.size()));
  crypto_generichash_final(&state, reinterpret_cast<unsigned char*>(sum.data()), sum.size());
  return sum;
}

std::optional<std::size_t> place_of(std::span<const std::byte> file, const Checksum& value) {
  const std::boyer_moore_horspool_searcher search(value.begin(), value.end());
  const auto first = std::search(file.begin(), file.end(), search);
  if (first == file.end() || std::search(first + 1, file.end(), search) != file.end()) return {};
  return static_cast<std::size_t>(first - file.begin());
}

}  // namespace docent::sqlite
