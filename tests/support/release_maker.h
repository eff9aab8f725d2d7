#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "content/write/content_writer.h"
#include "content/write/replace_file.h"
#include "platform/signature/digest.h"
#include "platform/signature/signed_text.h"
#include "platform/sqlite/checksum.h"
#include "platform/sqlite/signature_block.h"
#include "runtime/release/manifest.h"
#include "runtime/schema/schema.h"
#include "tests/support/small_museum.h"

namespace docent::test {

/// A museum's database, signed.
inline std::vector<std::byte> signed_museum(const Museum& museum, const signature::SecretKey& key) {
  std::vector<std::byte> file = write::encode_museum(museum);
  const std::filesystem::path name =
      std::filesystem::temp_directory_path() / fmt::format("docent-made-{}.db", ::getpid());
  write::replace_file(name, file);
  file = sqlite::signed_file(sqlite::open_database(name).value(), name, key).value();
  std::filesystem::remove(name);
  return file;
}

/// A small one, whose title says which it is.
inline std::vector<std::byte> signed_museum(const std::string& title,
                                            const signature::SecretKey& key) {
  Museum museum = small_museum();
  museum.title["en"] = title;
  return signed_museum(museum, key);
}

/// Makes releases in a folder, as `docent-content release` does, at any time.
struct ReleaseMaker {
  std::filesystem::path folder;
  signature::SecretKey key = signature::make_key();

  /// Adds a file to the folder and to the manifest.
  void add(release::Manifest& manifest, std::span<const std::byte> bytes,
           std::uint32_t schema = schema::version) const {
    signature::Digest digest;
    digest.add(bytes);
    release::ReleasedFile file{
        .schema = schema, .size = bytes.size(), .hash = digest.finish(), .name = {}};
    file.name = fmt::format("museum-s{}-{}.db", schema, file.hash.substr(0, 16));
    write::replace_file(folder / file.name, bytes);
    manifest.files.push_back(std::move(file));
  }

  void publish(const release::Manifest& manifest) const {
    const std::string text = signature::to_signed_text(release::to_text(manifest),
                                                       signature::Purpose::Release, {&key, 1});
    write::replace_file(folder / release::manifest_name, std::as_bytes(std::span(text)));
  }
};

}  // namespace docent::test
