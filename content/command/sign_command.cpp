#include <fmt/core.h>

#include <array>
#include <filesystem>
#include <memory>
#include <string>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/content_error.h"
#include "content/write/replace_file.h"
#include "platform/file/write_file.h"
#include "platform/signature/key.h"
#include "platform/sqlite/signature_block.h"

namespace docent::command {
namespace {

template <typename T>
T or_throw(Result<T> result, const std::string& file, const char* code) {
  if (!result) throw content::to_content_error(result.error(), file, code);
  return std::move(*result);
}

void create_or_throw(const std::string& file, const std::string& text, mode_t mode) {
  const Result<void> made = file::create_file(file, std::as_bytes(std::span(text)), mode);
  if (!made) throw content::to_content_error(made.error(), file, "cannot-write");
}

int run_keygen(const std::string& name) {
  const std::string secret_file = name + ".key", public_file = name + ".pub";
  const signature::SecretKey key = signature::make_key();
  create_or_throw(secret_file, signature::to_text(key), 0600);
  try {
    create_or_throw(public_file, signature::to_text(signature::public_key(key)), 0644);
  } catch (const content::ContentError&) {
    std::error_code ignored;
    std::filesystem::remove(secret_file, ignored);  // half a pair is of no use
    throw;
  }
  fmt::print("{}: the secret key, for signing; {}: the public key, for kiosks\n", secret_file,
             public_file);
  return 0;
}

int run_sign(const std::string& file, const std::string& key_file) {
  const signature::SecretKey key =
      or_throw(signature::read_secret_key(key_file), key_file, "unusable-key");
  const sqlite::Database database = open_or_throw(file);
  const auto bytes =
      or_throw(sqlite::signed_file(database, file, key), file, "too-many-signatures");
  write::replace_file(file, bytes);
  fmt::print("{}: signed with key {}\n", file,
             signature::name_of(signature::id_of(signature::public_key(key))));
  return 0;
}

int run_verify(const std::string& file, const std::string& key_file) {
  const std::array keys{or_throw(signature::read_public_key(key_file), key_file, "unusable-key")};
  const sqlite::Database database = open_or_throw(file);
  if (const Result<void> checked = sqlite::check_signature(database, file, keys); !checked)
    throw content::to_content_error(checked.error(), file, "wrong-signature");
  fmt::print("{}: signed with key {}\n", file, signature::name_of(signature::id_of(keys[0])));
  return 0;
}

struct SignOptions {
  std::string database, key;
};

}  // namespace

terminal::Command keygen_command() {
  const auto name = std::make_shared<std::string>();
  return {.name = "keygen",
          .manual =
              "makes a pair of keys: one to sign databases with, and one for kiosks, which "
              "then take no others",
          .options = {{"-o,--output", terminal::file("NAME", *name),
                       "NAME.key, the secret key, and NAME.pub, the public one; neither may exist",
                       terminal::Times::Once}},
          .run = [name] { return run_keygen(*name); }};
}

terminal::Command sign_command() {
  const auto options = std::make_shared<SignOptions>();
  return {.name = "sign",
          .manual = "signs a database: adds the key's signature, or makes it anew",
          .options = {{"DB", terminal::file("DB", options->database), "The museum's database",
                       terminal::Times::Once},
                      {"--key", terminal::file("NAME.key", options->key), "The secret key",
                       terminal::Times::Once}},
          .run = [options] { return run_sign(options->database, options->key); }};
}

terminal::Command verify_command() {
  const auto options = std::make_shared<SignOptions>();
  return {.name = "verify",
          .manual = "says whether a database is signed with a key, or why not",
          .options = {{"DB", terminal::file("DB", options->database), "The museum's database",
                       terminal::Times::Once},
                      {"--key", terminal::file("NAME.pub", options->key), "The public key",
                       terminal::Times::Once}},
          .run = [options] { return run_verify(options->database, options->key); }};
}

}  // namespace docent::command
