#include "runtime/schema/object_blob.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "runtime/schema/elements.h"

namespace docent::schema {
namespace {

/// What stands before the arrays.
struct Head {
  std::array<std::uint32_t, 5> count{};  ///< Vertices, corners, parts, pictures, their bytes.
  std::array<float, 4> uv{};             ///< Low, size.
};

void fields(auto& io, MaybeConst<Head> auto& head) {
  io(head.count, head.uv);
}

/// Takes elements off the front of the bytes.
class Reader {
 public:
  explicit Reader(std::span<const std::byte> bytes) : bytes_{bytes} {}

  template <typename T>
  bool take(std::size_t count, std::vector<T>& elements) {
    const std::size_t size = encoded_size<T>();
    if (count > bytes_.size() / size) return false;
    const bool is_read = decode(bytes_.first(count * size), elements);
    bytes_ = bytes_.subspan(count * size);
    return is_read;
  }
  std::size_t left() const noexcept { return bytes_.size(); }

 private:
  std::span<const std::byte> bytes_;
};

bool covers(std::span<const ObjectPart> parts, std::size_t corners, std::size_t pictures) {
  if (std::max(parts.size(), pictures) > ObjectDetail::most_parts) return false;
  std::size_t next = 0;
  for (const ObjectPart& part : parts) {
    if (part.first_index != next || part.index_count % 3 != 0) return false;
    if (part.picture < -1 || part.picture >= static_cast<std::int64_t>(pictures)) return false;
    if (std::max(part.wrap[0], part.wrap[1]) > ObjectWrap::Mirror) return false;
    next += part.index_count;
  }
  return next == corners;
}

}  // namespace

bool is_whole(const ObjectMesh& mesh) noexcept {
  return mesh.triangles.size() % 3 == 0 &&
         std::ranges::all_of(mesh.triangles,
                             [&](std::uint16_t corner) { return corner < mesh.vertices.size(); });
}

std::vector<std::byte> encode(const ObjectDetail& detail) {
  Head head{.count = {static_cast<std::uint32_t>(detail.mesh.vertices.size()),
                      static_cast<std::uint32_t>(detail.mesh.triangles.size()),
                      static_cast<std::uint32_t>(detail.parts.size()),
                      static_cast<std::uint32_t>(detail.pictures.size()), 0},
            .uv = {detail.uv_low.x, detail.uv_low.y, detail.uv_size.x, detail.uv_size.y}};
  std::vector<std::uint32_t> lengths;
  for (const std::vector<std::byte>& picture : detail.pictures) {
    lengths.push_back(static_cast<std::uint32_t>(picture.size()));
    head.count[4] += lengths.back();
  }
  std::vector<std::byte> bytes;
  const auto add = [&](const std::vector<std::byte>& more) {
    bytes.insert(bytes.end(), more.begin(), more.end());
  };
  add(encode(std::array{head}));
  add(encode(detail.mesh.vertices));
  add(encode(detail.mesh.triangles));
  add(encode(detail.parts));
  add(encode(lengths));
  for (const std::vector<std::byte>& picture : detail.pictures) add(picture);
  return bytes;
}

bool decode(std::span<const std::byte> bytes, ObjectDetail& detail) {
  Reader reader(bytes);
  std::vector<Head> head;
  if (!reader.take(1, head)) return false;
  const auto [vertices, corners, parts, pictures, picture_bytes] = head[0].count;
  const std::array<float, 4>& uv = head[0].uv;
  ObjectDetail made;
  made.uv_low = {uv[0], uv[1]};
  made.uv_size = {uv[2], uv[3]};
  if (!std::ranges::all_of(uv, [](float number) { return std::isfinite(number); })) return false;
  if (corners > 3 * ObjectDetail::most_triangles) return false;
  std::vector<std::uint32_t> lengths;
  if (!reader.take(vertices, made.mesh.vertices) || !reader.take(corners, made.mesh.triangles) ||
      !reader.take(parts, made.parts) || !reader.take(pictures, lengths) ||
      reader.left() != picture_bytes)
    return false;
  for (const std::uint32_t length : lengths)
    if (!reader.take(length, made.pictures.emplace_back())) return false;
  if (reader.left() != 0 || !is_whole(made.mesh) ||
      !covers(made.parts, made.mesh.triangles.size(), made.pictures.size()))
    return false;
  detail = std::move(made);
  return true;
}

}  // namespace docent::schema
