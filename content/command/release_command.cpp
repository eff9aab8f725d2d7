#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "content/command/commands.h"
#include "content/command/open_museum.h"
#include "content/content_error.h"
#include "content/write/replace_file.h"
#include "content/write/zchunk.h"
#include "platform/file/read_file.h"
#include "platform/signature/digest.h"
#include "platform/signature/signed_text.h"
#include "platform/sqlite/signature_block.h"
#include "runtime/release/manifest.h"
#include "runtime/schema/schema.h"

namespace docent::command {
namespace {

namespace fs = std::filesystem;
using content::ContentError;
using release::Manifest;
using release::ReleasedFile;

struct ReleaseOptions {
  std::vector<std::string> databases, keys, groups;
  std::string folder, program;
  std::optional<double> number;
  double expires_days = 30, rollout_hours = 0;
  std::vector<double> halted;
};

release::Time now() {
  return std::chrono::duration_cast<std::chrono::seconds>(
             std::chrono::system_clock::now().time_since_epoch())
      .count();
}

std::vector<signature::SecretKey> read_keys(const std::vector<std::string>& files) {
  std::vector<signature::SecretKey> keys;
  for (const std::string& file : files) {
    const auto key = signature::read_secret_key(file);
    if (!key) throw content::to_content_error(key.error(), file, "unusable-key");
    keys.push_back(*key);
  }
  return keys;
}

/// The release that the folder holds already, so that the next has a higher number; empty where
/// there is none, or it was not signed with one of our keys.
std::optional<Manifest> present_release(const fs::path& folder,
                                        std::span<const signature::SecretKey> keys) {
  const fs::path file = folder / release::manifest_name;
  const auto bytes = file::read_file(file, release::largest_manifest);
  if (!bytes) return std::nullopt;
  std::vector<signature::PublicKey> known;
  for (const signature::SecretKey& key : keys) known.push_back(signature::public_key(key));
  const auto text =
      signature::read_signed_text(*bytes, signature::Purpose::Release, known, file.string());
  const auto manifest = text ? release::parse_manifest(*text, file.string())
                             : Result<Manifest>(std::unexpected(text.error()));
  return manifest ? std::optional(*manifest) : std::nullopt;
}

/// The number of the release to make, higher than that of the one before.
std::uint64_t number_of(const ReleaseOptions& options, const std::optional<Manifest>& before) {
  const std::uint64_t least = before ? before->version + 1 : 1;
  const std::uint64_t number = options.number ? static_cast<std::uint64_t>(*options.number) : least;
  if (number < least)
    throw ContentError(Errc::InvalidInput, options.folder, "old-release",
                       fmt::format("holds release {} already", before->version),
                       fmt::format("kiosks take higher numbers only: {} is the next", least));
  return number;
}

/// The database's bytes, signed with all keys. One of another schema version was checked and signed
/// by the docent-content that made it.
std::vector<std::byte> signed_bytes(const std::string& file, std::uint32_t schema,
                                    std::span<const signature::SecretKey> keys) {
  if (schema != schema::version) {
    const auto text = file::read_file(file);
    if (!text) throw content::to_content_error(text.error(), file, "unusable-database");
    const auto bytes = std::as_bytes(std::span(*text));
    return {bytes.begin(), bytes.end()};
  }
  sqlite::Database database = open_or_throw(file);
  for (const signature::SecretKey& key : keys)
    signature::put(signature::sign(signature::Purpose::Database, database.checksum, key),
                   database.signatures);
  const auto bytes = sqlite::signed_file(database, file, keys.front());
  if (!bytes) throw content::to_content_error(bytes.error(), file, "too-many-signatures");
  return *bytes;
}

ReleasedFile put_database(const std::string& file, const fs::path& folder,
                          std::span<const signature::SecretKey> keys) {
  const std::uint32_t schema = sqlite::schema_version_of(file);
  if (schema == 0)
    throw ContentError(Errc::InvalidInput, file, "unusable-database", "is not a docent database",
                       "name one made by 'docent-content compile'");
  const std::vector<std::byte> bytes = signed_bytes(file, schema, keys);
  if (bytes.size() > schema::largest_shown)
    throw ContentError(Errc::InvalidInput, file, "database-too-large",
                       fmt::format("has {} MB, and the most that a kiosk shows is {}",
                                   bytes.size() >> 20U, schema::largest_shown >> 20U),
                       "compile it with fewer or smaller pictures, or several museums of it");
  signature::Digest digest;
  digest.add(bytes);
  ReleasedFile made{.schema = schema, .size = bytes.size(), .hash = digest.finish(), .name = {}};
  constexpr std::size_t enough = 16;
  made.name = fmt::format("museum-s{}-{}.db", schema, made.hash.substr(0, enough));
  write::replace_file(folder / made.name, bytes);
  write::write_zchunk(folder / made.name);
  return made;
}

Manifest manifest_of(const ReleaseOptions& options, std::span<const signature::SecretKey> keys) {
  constexpr double day = 86400;
  Manifest manifest;
  const std::optional<Manifest> before = present_release(options.folder, keys);
  manifest.version = number_of(options, before);
  manifest.issued = now();
  manifest.expires = manifest.issued + static_cast<release::Time>(options.expires_days * day);
  manifest.program = options.program;
  manifest.groups = options.groups;
  for (const std::string& group : options.groups)
    if (!release::is_group_name(group))
      throw ContentError(Errc::WrongUsage, "--group", "bad-value",
                         fmt::format("'{}' is not a group's name: letters, digits, '.', '-' and "
                                     "'_'",
                                     group));
  manifest.rollout = {.start = manifest.issued,
                      .hours = static_cast<std::uint64_t>(options.rollout_hours)};
  if (before) manifest.halted = before->halted;  // what was withdrawn stays so
  for (const double version : options.halted)
    if (std::ranges::find(manifest.halted, version) == manifest.halted.end())
      manifest.halted.push_back(static_cast<std::uint64_t>(version));
  return manifest;
}

int run_release(const ReleaseOptions& options) {
  const std::vector<signature::SecretKey> keys = read_keys(options.keys);
  std::error_code status;
  fs::create_directories(options.folder, status);
  Manifest manifest = manifest_of(options, keys);
  for (const std::string& file : options.databases) {
    ReleasedFile made = put_database(file, options.folder, keys);
    if (release::file_for(manifest, made.schema) != nullptr)
      throw ContentError(Errc::InvalidInput, file, "same-schema",
                         fmt::format("is the second database of schema version {}", made.schema),
                         "a release holds one for each version of the program");
    manifest.files.push_back(std::move(made));
  }
  // Last: whoever sees it finds its files.
  const std::string text =
      signature::to_signed_text(release::to_text(manifest), signature::Purpose::Release, keys);
  write::replace_file(fs::path(options.folder) / release::manifest_name,
                      std::as_bytes(std::span(text)));
  fmt::print("{}: release {}, until {}, {} bytes of manifest\n", options.folder, manifest.version,
             release::text_of(manifest.expires), text.size());
  return 0;
}

}  // namespace

terminal::Command release_command() {
  using terminal::Limits;
  using terminal::Times;
  const auto options = std::make_shared<ReleaseOptions>();
  const Limits whole{.of = Limits::Of::WholeNumbers, .least = 1, .most = 1e15};
  return {
      .name = "release",
      .manual = "makes a signed release that docent-update takes from a web server or a USB stick",
      .options =
          {{"DB", terminal::file("DB", options->databases),
            "The museum's database, and one for each other schema version that kiosks have",
            Times::AtLeastOnce},
           {"-o,--output", terminal::folder("DIR", options->folder),
            "The release's folder: the manifest and the databases, for any static web server",
            Times::Once},
           {"--key", terminal::file("NAME.key", options->keys),
            "The secret key; two while keys are rotated", Times::AtLeastOnce},
           {"--release", terminal::number("N", whole, options->number),
            "The release's number, which only rises", Times::AtMostOnce,
            "one more than the folder's"},
           {"--expires",
            terminal::number("DAYS", Limits{.least = 0.01, .most = 3650}, options->expires_days),
            "Days after which kiosks no longer take it", Times::AtMostOnce, "30"},
           {"--group", terminal::text("GROUP", options->groups),
            "Only for kiosks whose kiosk.toml names this group", Times::AnyNumber},
           {"--rollout",
            terminal::number("HOURS",
                             Limits{.of = Limits::Of::WholeNumbers, .least = 0, .most = 8760},
                             options->rollout_hours),
            "Spread it over so many hours", Times::AtMostOnce, "0: everybody at once"},
           {"--halt", terminal::number("N", whole, options->halted),
            "A release to withdraw: kiosks that show it take this one at once", Times::AnyNumber},
           {"--program", terminal::text("VERSION", options->program),
            "The oldest docent that may take it"}},
      .run = [options] { return run_release(*options); }};
}

}  // namespace docent::command
