#include "platform/signature/key.h"

#include <fmt/format.h>
#include <sodium/crypto_generichash.h>
#include <sodium/crypto_sign_ed25519.h>
#include <sodium/randombytes.h>
#include <sodium/utils.h>

#include <algorithm>
#include <optional>

#include "platform/file/read_file.h"

namespace docent::signature {
namespace {

using Bytes = std::array<std::byte, 32>;
static_assert(crypto_sign_ed25519_SEEDBYTES == 32 && crypto_sign_ed25519_PUBLICKEYBYTES == 32);

constexpr std::string_view public_form = "docent-public-key-1 ";
constexpr std::string_view secret_form = "docent-secret-key-1 ";
constexpr std::size_t largest_key_file = 4096;

unsigned char* raw(std::byte* bytes) {
  return reinterpret_cast<unsigned char*>(bytes);
}
const unsigned char* raw(const std::byte* bytes) {
  return reinterpret_cast<const unsigned char*>(bytes);
}

std::string base64_of(const Bytes& bytes) {
  std::string text(
      sodium_base64_ENCODED_LEN(std::tuple_size_v<Bytes>, sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(text.data(), text.size(), raw(bytes.data()), bytes.size(),
                    sodium_base64_VARIANT_ORIGINAL);
  text.pop_back();  // the zero behind it
  return text;
}

std::optional<Bytes> from_base64(std::string_view text) {
  Bytes bytes{};
  std::size_t size = 0;
  const char* end = nullptr;
  const int read = sodium_base642bin(raw(bytes.data()), bytes.size(), text.data(), text.size(),
                                     nullptr, &size, &end, sodium_base64_VARIANT_ORIGINAL);
  if (read != 0 || size != bytes.size() || end != text.data() + text.size()) return std::nullopt;
  return bytes;
}

/// The one line of the text that is no comment; nothing where there are none or several.
std::string_view only_line(std::string_view text) {
  std::string_view found;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    if (!found.empty()) return {};
    found = line;
  }
  return found;
}

std::unexpected<Error> no_key(const std::filesystem::path& file, std::string_view sentence) {
  return std::unexpected(Error{Errc::InvalidInput, fmt::format("{}: {}", file.string(), sentence)});
}

/// The bytes of a key of one form, or a sentence; `other` is the form that it is taken for most
/// easily.
Result<Bytes> parse(std::string_view text, const std::filesystem::path& file, std::string_view form,
                    std::string_view other, std::string_view mixed_up) {
  const std::string_view line = only_line(text);
  if (line.starts_with(other)) return no_key(file, mixed_up);
  if (!line.starts_with(form))
    return no_key(file, "is not a key; 'docent-content keygen' makes keys");
  const auto bytes = from_base64(line.substr(form.size()));
  if (!bytes) return no_key(file, "holds a key that is cut short or altered; copy it again");
  return *bytes;
}

template <typename Key>
Result<Key> read(const std::filesystem::path& file,
                 Result<Key> (*parse_text)(std::string_view, const std::filesystem::path&)) {
  const Result<std::string> text = file::read_file(file, largest_key_file);
  if (!text) return std::unexpected(text.error());
  return parse_text(*text, file);
}

}  // namespace

SecretKey make_key() {
  SecretKey key;
  randombytes_buf(key.seed.data(), key.seed.size());
  return key;
}

PublicKey public_key(const SecretKey& key) {
  PublicKey made;
  std::array<unsigned char, crypto_sign_ed25519_SECRETKEYBYTES> both{};
  crypto_sign_ed25519_seed_keypair(raw(made.bytes.data()), both.data(), raw(key.seed.data()));
  sodium_memzero(both.data(), both.size());
  return made;
}

KeyId id_of(const PublicKey& key) {
  std::array<std::byte, 32> sum{};
  crypto_generichash(raw(sum.data()), sum.size(), raw(key.bytes.data()), key.bytes.size(), nullptr,
                     0);
  KeyId id{};
  std::copy_n(sum.begin(), id.size(), id.begin());
  return id;
}

std::string name_of(const KeyId& id) {
  std::string name;
  for (const std::byte byte : id) name += fmt::format("{:02x}", std::to_integer<unsigned>(byte));
  return name;
}

std::string to_text(const PublicKey& key) {
  return fmt::format("# docent, public key {}: kiosks that have it take what is signed with it\n",
                     name_of(id_of(key))) +
         fmt::format("{}{}\n", public_form, base64_of(key.bytes));
}

std::string to_text(const SecretKey& key) {
  return fmt::format(
             "# docent, secret key {}: who has it decides what kiosks show; keep it off "
             "them, and a copy safe\n",
             name_of(id_of(public_key(key)))) +
         fmt::format("{}{}\n", secret_form, base64_of(key.seed));
}

Result<PublicKey> parse_public_key(std::string_view text, const std::filesystem::path& file) {
  const Result<Bytes> bytes =
      parse(text, file, public_form, secret_form,
            "is the secret key, which belongs on no kiosk; name the one that ends in .pub");
  if (!bytes) return std::unexpected(bytes.error());
  return PublicKey{*bytes};
}

Result<SecretKey> parse_secret_key(std::string_view text, const std::filesystem::path& file) {
  const Result<Bytes> bytes =
      parse(text, file, secret_form, public_form,
            "is the public key, which signs nothing; name the one that ends in .key");
  if (!bytes) return std::unexpected(bytes.error());
  return SecretKey{*bytes};
}

Result<PublicKey> read_public_key(const std::filesystem::path& file) {
  return read<PublicKey>(file, parse_public_key);
}

Result<SecretKey> read_secret_key(const std::filesystem::path& file) {
  return read<SecretKey>(file, parse_secret_key);
}

Result<std::vector<PublicKey>> read_public_keys(std::span<const std::filesystem::path> files) {
  std::vector<PublicKey> keys;
  for (const std::filesystem::path& file : files) {
    const Result<PublicKey> key = read_public_key(file);
    if (!key) return std::unexpected(key.error());
    keys.push_back(*key);
  }
  return keys;
}

}  // namespace docent::signature
