#include "content/import/gltf/source.h"

#include <meshoptimizer.h>

#include <algorithm>
#include <array>
#include <optional>

namespace docent::import::gltf {
namespace {

constexpr std::size_t most_unpacked = std::size_t{256} << 20U;
constexpr std::size_t most_warnings = 50;

std::optional<std::string> decode_base64(std::string_view text) {
  std::array<std::int8_t, 256> value{};
  value.fill(-1);
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  for (std::size_t i = 0; i < letters.size(); ++i)
    value[static_cast<std::uint8_t>(letters[i])] = static_cast<std::int8_t>(i);
  while (text.ends_with('=')) text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() * 3 / 4);
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const std::int8_t six = value[static_cast<std::uint8_t>(c)];
    if (six < 0) return {};
    bits = bits << 6U | static_cast<std::uint32_t>(six);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes += static_cast<char>(bits >> static_cast<unsigned>(held) & 0xFFU);
  }
  return bytes;
}

std::string without_percents(std::string_view uri) {
  const auto digit = [](char c) {
    return c >= '0' && c <= '9'   ? c - '0'
           : c >= 'a' && c <= 'f' ? c - 'a' + 10
           : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                  : -1;
  };
  std::string name;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
      name += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
      i += 2;
    } else {
      name += uri[i];
    }
  }
  return name;
}

}  // namespace

bool stays_below(std::string_view name) {
  if (name.empty() || name.starts_with('/') || name.contains('\\') || name.contains(':') ||
      name.contains('\0'))
    return false;
  for (std::size_t at = 0; at <= name.size();) {
    const std::size_t end = std::min(name.find('/', at), name.size());
    if (name.substr(at, end - at) == "..") return false;
    at = end + 1;
  }
  return true;
}

Source::Source(std::string_view bytes, const std::string& file, const ReadBeside& beside)
    : file_{file}, container_{open_container(bytes, file)}, beside_{beside} {}

void Source::warn(std::string sentence) {
  if (warnings.size() < most_warnings && std::ranges::find(warnings, sentence) == warnings.end())
    warnings.push_back(std::move(sentence));
}

void Source::count_vertices(std::size_t more, const Part& part) {
  if (more > most_vertices - vertices_)
    part.fail(fmt::format("makes more than {} vertices in all", most_vertices));
  vertices_ += more;
}

void Source::count_corners(std::size_t more, const Part& part) {
  if (more > most_corners - corners_)
    part.fail(fmt::format("makes more than {} triangles in all", most_corners / 3));
  corners_ += more;
}

std::optional<std::string> Source::bytes_of_uri(const Part& uri) {
  const std::string text = uri.text();
  if (text.starts_with("data:")) {
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos || !std::string_view(text).substr(0, comma).ends_with(";base64"))
      uri.fail("is a data: URI that is not in base64");
    std::optional<std::string> bytes = decode_base64(std::string_view(text).substr(comma + 1));
    if (!bytes) uri.fail("is not base64 throughout");
    return bytes;
  }
  const std::string name = without_percents(text);
  if (!stays_below(name))
    uri.fail(fmt::format("names '{}', which is not in the model's own folder", plain_name(name)));
  return beside_ ? beside_(name) : std::nullopt;
}

std::string_view Source::buffer(std::uint64_t index, const Part& asked_by) {
  const Part buffers = root()["buffers"];
  if (index >= buffers.size())
    asked_by.fail(fmt::format("names buffer {}, and the file has {}", index, buffers.size()));
  const Part part = buffers.at(index);
  const std::uint64_t length = part["byteLength"].whole(1, UINT32_MAX);
  const Part uri = part["uri"];
  std::string_view bytes;
  if (!uri.is_there()) {
    if (index != 0 || !container_.has_binary)
      part.fail("names no file, and the GLB holds no binary chunk for it");
    bytes = container_.binary;
  } else {
    auto found = buffers_.find(index);
    if (found == buffers_.end()) {
      std::optional<std::string> read = bytes_of_uri(uri);
      if (!read) uri.fail(fmt::format("names '{}', which is not there", plain_name(uri.text())));
      found = buffers_.emplace(index, std::move(*read)).first;
    }
    bytes = found->second;
  }
  if (length > bytes.size())
    part.fail(fmt::format("says that it is {} bytes long, and has {}", length, bytes.size()));
  return bytes.substr(0, length);
}

std::string_view Source::unpacked(const Part& view, const Part& packed, std::uint64_t index,
                                  std::uint64_t length) {
  if (const auto found = unpacked_.find(index); found != unpacked_.end()) return found->second;
  const std::uint64_t count = packed["count"].whole(1, most_corners);
  const std::uint64_t stride = packed["byteStride"].whole(1, 256);
  if (count * stride != length)
    view.fail(
        fmt::format("says that it is {} bytes long, and unpacks to {}", length, count * stride));
  if (length > most_unpacked - unpacked_bytes_)
    view.fail(fmt::format("unpacks to more than {} MB in all", most_unpacked >> 20U));
  unpacked_bytes_ += length;
  const std::string_view source = buffer(packed["buffer"].whole(0, UINT32_MAX), packed);
  const std::uint64_t offset = packed["byteOffset"].whole_or(0, UINT32_MAX);
  const std::uint64_t size = packed["byteLength"].whole(1, UINT32_MAX);
  if (offset > source.size() || size > source.size() - offset)
    packed.fail("reaches beyond its buffer");
  const auto* bytes = reinterpret_cast<const unsigned char*>(source.data()) + offset;

  std::string out(length, '\0');
  const std::string mode = packed["mode"].text();
  int status = -1;
  if (mode == "ATTRIBUTES" && stride % 4 == 0)
    status = meshopt_decodeVertexBuffer(out.data(), count, stride, bytes, size);
  else if (mode == "TRIANGLES" && count % 3 == 0 && (stride == 2 || stride == 4))
    status = meshopt_decodeIndexBuffer(out.data(), count, stride, bytes, size);
  else if (mode == "INDICES" && (stride == 2 || stride == 4))
    status = meshopt_decodeIndexSequence(out.data(), count, stride, bytes, size);
  if (status != 0) packed.fail("cannot be unpacked");
  const std::string filter = packed["filter"].text_or("NONE");
  if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8))
    meshopt_decodeFilterOct(out.data(), count, stride);
  else if (filter == "QUATERNION" && stride == 8)
    meshopt_decodeFilterQuat(out.data(), count, stride);
  else if (filter == "EXPONENTIAL" && stride % 4 == 0)
    meshopt_decodeFilterExp(out.data(), count, stride);
  else if (filter != "NONE")
    packed["filter"].fail("is not one that can be undone");
  return unpacked_.emplace(index, std::move(out)).first->second;
}

Source::View Source::view(std::uint64_t index) {
  const Part view = root()["bufferViews"].at(index);
  const std::uint64_t length = view["byteLength"].whole(1, UINT32_MAX);
  const Part stride = view["byteStride"];
  const std::size_t step = stride.is_there() ? stride.whole(4, 252) : 0;
  if (const Part packed = view["extensions"].is_there()
                              ? view["extensions"]["EXT_meshopt_compression"]
                              : view["extensions"];
      packed.is_there())
    return {unpacked(view, packed, index, length), step};
  const std::string_view bytes = buffer(view["buffer"].whole(0, UINT32_MAX), view);
  const std::uint64_t offset = view["byteOffset"].whole_or(0, UINT32_MAX);
  if (offset > bytes.size() || length > bytes.size() - offset)
    view.fail(fmt::format("reaches to byte {}, beyond the {} of its buffer", offset + length,
                          bytes.size()));
  return {bytes.substr(offset, length), step};
}

}  // namespace docent::import::gltf
