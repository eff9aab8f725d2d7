#include "platform/signature/signed_text.h"

#include <fmt/format.h>
#include <sodium/utils.h>

#include <optional>
#include <vector>

namespace docent::signature {
namespace {

constexpr std::string_view mark = "signature ";

std::string line_of(const Signature& signature) {
  std::string line = fmt::format("{}{} ", mark, name_of(signature.key));
  for (const std::byte byte : signature.bytes)
    line += fmt::format("{:02x}", std::to_integer<unsigned>(byte));
  return line + "\n";
}

template <std::size_t size>
bool read_hexadecimal(std::string_view digits, std::array<std::byte, size>& bytes) {
  std::size_t read = 0;
  return digits.size() == 2 * size &&
         sodium_hex2bin(reinterpret_cast<unsigned char*>(bytes.data()), size, digits.data(),
                        digits.size(), nullptr, &read, nullptr) == 0 &&
         read == size;
}

std::optional<Signature> read_line(std::string_view line) {
  Signature signature;
  constexpr std::size_t id_digits = 2 * sizeof(KeyId);
  if (!line.starts_with(mark)) return std::nullopt;
  line.remove_prefix(mark.size());
  if (line.size() <= id_digits || line[id_digits] != ' ') return std::nullopt;
  if (!read_hexadecimal(line.substr(0, id_digits), signature.key) ||
      !read_hexadecimal(line.substr(id_digits + 1), signature.bytes))
    return std::nullopt;
  return signature;
}

/// Takes the signatures off the end of the bytes.
std::vector<Signature> take_signatures(std::string_view& bytes) {
  std::vector<Signature> signatures;
  while (bytes.ends_with('\n')) {
    const std::size_t before =
        bytes.size() < 2 ? std::string_view::npos : bytes.rfind('\n', bytes.size() - 2);
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const auto signature = read_line(bytes.substr(begin, bytes.size() - 1 - begin));
    if (!signature) break;
    signatures.push_back(*signature);
    bytes = bytes.substr(0, begin);
  }
  return signatures;
}

}  // namespace

std::string to_signed_text(std::string_view text, Purpose purpose,
                           std::span<const SecretKey> keys) {
  std::string bytes(text);
  for (const SecretKey& key : keys)
    bytes += line_of(sign(purpose, std::as_bytes(std::span(text)), key));
  return bytes;
}

Result<std::string> read_signed_text(std::string_view bytes, Purpose purpose,
                                     std::span<const PublicKey> keys, const std::string& where) {
  const std::vector<Signature> signatures = take_signatures(bytes);
  if (!is_signed(purpose, std::as_bytes(std::span(bytes)), signatures, keys))
    return std::unexpected(
        Error{Errc::InvalidInput,
              fmt::format("{}: {}; it is not taken", where, why_not_signed(signatures, keys))});
  return std::string(bytes);
}

}  // namespace docent::signature
