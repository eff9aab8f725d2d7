#include "content/import/gltf/container.h"

#include <fmt/format.h>

#include <cstdint>

#include "content/content_error.h"
#include "content/import/gltf/part.h"

namespace docent::import::gltf {
namespace {

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr std::size_t glb_header = 12, chunk_header = 8;
/// A model's JSON takes some ten times as much memory as text.
constexpr std::size_t longest_json = std::size_t{64} << 20U;
constexpr int deepest_json = 64;

[[noreturn]] void fail(const std::string& file, const std::string& what) {
  throw content::ContentError(file, 0, 0, "unreadable-model", what,
                              "copy or export the model again as glTF 2.0 or VRM");
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8U | static_cast<std::uint8_t>(bytes[at + i]);
  return value;
}

nlohmann::json parse_json(std::string_view text, const std::string& file) {
  if (text.size() > longest_json)
    fail(file, fmt::format("its JSON is longer than {} MB", longest_json >> 20U));
  using Json = nlohmann::json;
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  if (first == std::string_view::npos || (text[first] != '{' && text[first] != '['))
    fail(file, "this is neither glTF nor VRM: it begins neither as GLB nor as JSON");
  bool is_too_deep = false;
  const auto keep = [&](int depth, Json::parse_event_t, Json&) {
    is_too_deep = is_too_deep || depth > deepest_json;
    return !is_too_deep;
  };
  try {
    Json json = Json::parse(text, keep);
    if (is_too_deep) fail(file, "its JSON is nested too deeply");
    if (!json.is_object()) fail(file, "its JSON is no object");
    return json;
  } catch (const Json::parse_error& error) {
    fail(file, fmt::format("its JSON is broken at byte {}", error.byte));
  } catch (const Json::exception&) {
    fail(file, "its JSON holds a number that is out of range");
  }
}

struct Chunk {
  std::uint32_t kind = 0;
  std::string_view bytes;
};

Chunk chunk_at(std::string_view bytes, std::size_t& at, std::size_t number,
               const std::string& file) {
  if (bytes.size() - at < chunk_header)
    fail(file, fmt::format("the file is cut short in the header of chunk {}", number));
  const std::uint32_t length = number_at(bytes, at), kind = number_at(bytes, at + 4);
  at += chunk_header;
  if (length > bytes.size() - at)
    fail(file, fmt::format("chunk {} says that it is {} bytes long, and {} are left: the file is "
                           "cut short, or the length is wrong",
                           number, length, bytes.size() - at));
  const Chunk chunk{kind, bytes.substr(at, length)};
  at += length;
  return chunk;
}

Container open_glb(std::string_view bytes, const std::string& file) {
  if (bytes.size() < glb_header)
    fail(file, fmt::format("the file is cut short: it has {} bytes of the 12 of a GLB's header",
                           bytes.size()));
  if (const std::uint32_t version = number_at(bytes, 4); version != 2)
    fail(file, fmt::format("this is GLB version {}, and only 2 can be read", version));
  const std::uint32_t length = number_at(bytes, 8);
  if (length > bytes.size())
    fail(file,
         fmt::format("the file is cut short: it has {} of its {} bytes", bytes.size(), length));
  if (length < glb_header) fail(file, "this GLB says that it is shorter than its own header");
  bytes = bytes.substr(0, length);
  std::size_t at = glb_header;
  const Chunk first = chunk_at(bytes, at, 0, file);
  if (first.kind != json_chunk) fail(file, "the first chunk of this GLB is not its JSON");
  Container container{.json = parse_json(first.bytes, file), .binary = {}};
  for (std::size_t number = 1; at < length; ++number) {
    const Chunk chunk = chunk_at(bytes, at, number, file);
    if (chunk.kind == json_chunk) fail(file, "this GLB has two chunks of JSON");
    if (chunk.kind != binary_chunk) continue;
    if (number != 1) fail(file, "the binary chunk of this GLB is not its second");
    container.binary = chunk.bytes;
    container.has_binary = true;
  }
  return container;
}

/// "2.0" as 2.
int major_of(const std::string& version) {
  return version.size() >= 2 && version[1] == '.' && version[0] >= '0' && version[0] <= '9'
             ? version[0] - '0'
             : -1;
}

}  // namespace

Container open_container(std::string_view bytes, const std::string& file) {
  if (bytes.empty()) fail(file, "the file is empty");
  const bool is_glb = bytes.starts_with("glTF");
  Container container =
      is_glb ? open_glb(bytes, file) : Container{.json = parse_json(bytes, file), .binary = {}};
  const Part asset = Part(file, &container.json, "")["asset"];
  const std::string version = asset["version"].text();
  if (major_of(version) != 2)
    asset["version"].fail(
        fmt::format("is \"{}\", and only glTF 2.0 can be read", plain_name(version)));
  const std::string least = asset["minVersion"].text_or("2.0");
  if (least != "2.0")
    asset["minVersion"].fail(
        fmt::format("is \"{}\", and only glTF 2.0 can be read", plain_name(least)));
  return container;
}

}  // namespace docent::import::gltf
