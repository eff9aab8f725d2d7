#include "runtime/release/manifest.h"

#include <fmt/format.h>

#include <algorithm>

namespace docent::release {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view manifest_head = "docent release 1\n";
constexpr std::size_t longest_name = 128;

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '-' || c == '_';
}

bool is_hash(std::string_view word) {
  return word.size() == 64 && std::ranges::all_of(word, [](char c) {
           return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
         });
}

template <typename T>
bool put(const std::optional<T>& read, T& value) {
  if (read) value = *read;
  return read.has_value();
}

bool read_file_line(const Words& words, Manifest& manifest) {
  if (words.size() != 5) return false;
  const auto schema = number_of(words[1]), size = number_of(words[2]);
  if (!schema || *schema > 0xffffffff || !size || !is_hash(words[3]) || !is_file_name(words[4]))
    return false;
  if (file_for(manifest, static_cast<std::uint32_t>(*schema)) != nullptr) return false;
  manifest.files.push_back({.schema = static_cast<std::uint32_t>(*schema),
                            .size = *size,
                            .hash = std::string(words[3]),
                            .name = std::string(words[4])});
  return true;
}

/// Takes one line; false where it is not one of a manifest.
bool read_line(const Words& words, Manifest& manifest) {
  const std::string_view fact = words[0];
  if (fact == "file") return read_file_line(words, manifest);
  if (fact == "rollout") {
    if (words.size() != 3) return false;
    // A century: elapsed time is multiplied with nothing that could overflow.
    return put(time_of(words[1]), manifest.rollout.start) &&
           put(number_of(words[2]), manifest.rollout.hours) && manifest.rollout.hours < 876'000;
  }
  if (words.size() != 2) return false;
  const std::string_view value = words[1];
  if (fact == "version") return put(number_of(value), manifest.version);
  if (fact == "issued") return put(time_of(value), manifest.issued);
  if (fact == "expires") return put(time_of(value), manifest.expires);
  if (fact == "program") {
    manifest.program = value;
    return true;
  }
  if (fact == "group") {
    manifest.groups.emplace_back(value);
    return is_group_name(value);
  }
  return fact == "halted" && put(number_of(value), manifest.halted.emplace_back());
}

std::unexpected<Error> no_manifest(const std::string& where, std::string_view sentence) {
  return std::unexpected(Error{Errc::InvalidInput, fmt::format("{}: {}", where, sentence)});
}

}  // namespace

std::string to_text(const Manifest& manifest) {
  std::string text(manifest_head);
  text += fmt::format("version {}\nissued {}\nexpires {}\n", manifest.version,
                      text_of(manifest.issued), text_of(manifest.expires));
  if (!manifest.program.empty()) text += fmt::format("program {}\n", manifest.program);
  for (const std::string& group : manifest.groups) text += fmt::format("group {}\n", group);
  if (manifest.rollout.hours > 0)
    text += fmt::format("rollout {} {}\n", text_of(manifest.rollout.start), manifest.rollout.hours);
  for (const std::uint64_t version : manifest.halted) text += fmt::format("halted {}\n", version);
  for (const ReleasedFile& file : manifest.files)
    text += fmt::format("file {} {} {} {}\n", file.schema, file.size, file.hash, file.name);
  return text;
}

Result<Manifest> parse_manifest(std::string_view text, const std::string& where) {
  if (!text.starts_with(manifest_head))
    return no_manifest(where, "is not the manifest of a release that this program knows");
  Manifest manifest;
  for (const Words& words : lines_of(text.substr(manifest_head.size())))
    if (!read_line(words, manifest))
      return no_manifest(where, fmt::format("has a line '{}' that cannot be understood",
                                            words[0].substr(0, longest_name)));
  if (manifest.version == 0 || manifest.issued == 0 || manifest.expires == 0 ||
      manifest.files.empty())
    return no_manifest(where, "lacks its version, its times or its files");
  return manifest;
}

const ReleasedFile* file_for(const Manifest& manifest, std::uint32_t schema) {
  const auto file = std::ranges::find(manifest.files, schema, &ReleasedFile::schema);
  return file == manifest.files.end() ? nullptr : &*file;
}

bool is_file_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && name.front() != '.' &&
         std::ranges::all_of(name, is_plain);
}

bool is_group_name(std::string_view name) {
  return !name.empty() && name.size() <= longest_name && std::ranges::all_of(name, is_plain);
}

}  // namespace docent::release
