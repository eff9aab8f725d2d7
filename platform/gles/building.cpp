#include "platform/gles/building.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "platform/gles/program.h"

namespace docent::gles {
namespace {

/// A vertex as it lies in texture memory: two thirds of the bytes, and no difference that is seen
/// (half a degree of a direction, two millimetres of a lightmap of 100 m).
struct PackedVertex {
  Vec3 position;
  std::array<std::int8_t, 4> normal;  ///< Of 127; the fourth is not read.
  std::array<std::uint16_t, 2> uv;    ///< Of 65535.
  std::array<std::uint8_t, 4> light;  ///< Sky and sun, of 255; the others are not read.
};
static_assert(sizeof(PackedVertex) == 24);

PackedVertex packed(const SceneryVertex& v) noexcept {
  const auto direction = [](float value) {
    return static_cast<std::int8_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 127));
  };
  const auto share = [](float value) {
    return static_cast<std::uint16_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 65535));
  };
  return {.position = v.position,
          .normal = {direction(v.normal.x), direction(v.normal.y), direction(v.normal.z), 0},
          .uv = {share(v.uv[0]), share(v.uv[1])},
          .light = {v.sky, v.sun, 0, 0}};
}

GlTexture make_map(const Scenery& scenery, Unit unit, GLenum format) noexcept {
  GlTexture map = make_texture();
  bind_texture(static_cast<GLuint>(unit), map.get());
  glTexStorage2D(GL_TEXTURE_2D, 1, format, static_cast<GLsizei>(scenery.lightmap_width),
                 static_cast<GLsizei>(scenery.lightmap_height));
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  return map;
}

float height_of_floor(const Scenery& scenery) noexcept {
  for (const SceneryPart& part : scenery.parts)
    if (part.surface == Surface::Floor || part.surface == Surface::Stone)
      return scenery.vertices[scenery.indices[part.first_index]].position.y;
  return 0;
}

/// Where a buffer is bound to be filled: no array of vertices that a pass left bound knows of it.
constexpr GLenum carrier = GL_COPY_WRITE_BUFFER;

void make_geometry(const Scenery& scenery, Building& building) noexcept {
  const auto allocate = [](std::size_t bytes) {
    GlBuffer buffer = make_buffer();
    glBindBuffer(carrier, buffer.get());
    glBufferData(carrier, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
    return buffer;
  };
  building.vertices = allocate(scenery.vertices.size() * sizeof(PackedVertex));
  building.indices = allocate(std::as_bytes(std::span(scenery.indices)).size());
}

void begin(Building& building, const Scenery& scenery, std::span<const scene::TextureId> image_of) {
  building.image_of.assign(image_of.begin(), image_of.end());
  building.scenery.parts = scenery.parts;
  building.hangs.assign(image_of.size(), false);
  for (const SceneryPart& part : scenery.parts)
    if (part.surface == Surface::Frame && part.exhibit >= 0 &&
        static_cast<std::size_t>(part.exhibit) < building.hangs.size())
      building.hangs[static_cast<std::size_t>(part.exhibit)] = true;
  building.scenery.lightmap_min = scenery.lightmap_min;
  building.scenery.lightmap_max = scenery.lightmap_max;
  building.scenery.sun = scenery.sun;
  if (scenery.vertices.empty()) return;
  building.floor_height = height_of_floor(scenery);
  make_geometry(scenery, building);
  building.lightmap = make_map(scenery, Unit::LightMap, GL_RG8);
  building.shade_map = make_map(scenery, Unit::ShadeMap, GL_R8);
}

/// What is carried to texture memory one after another: vertices, indices, and rows of the
/// lightmap, as bytes of the scenery.
struct Cargo {
  explicit Cargo(const Scenery& scenery)
      : vertices(scenery.vertices.size() * sizeof(SceneryVertex)),
        indices(scenery.indices.size() * sizeof(std::uint32_t)),
        lightmap(scenery.lightmap.size()) {}
  [[nodiscard]] std::size_t count() const { return vertices + indices + lightmap; }
  std::size_t vertices, indices, lightmap;
};

void carry_vertices(const Building& building, std::span<const SceneryVertex> vertices,
                    std::size_t first) noexcept {
  std::array<PackedVertex, 256> some{};
  glBindBuffer(carrier, building.vertices.get());
  for (std::size_t i = 0; i < vertices.size(); i += some.size()) {
    const std::size_t count = std::min(some.size(), vertices.size() - i);
    std::ranges::transform(vertices.subspan(i, count), some.begin(), packed);
    glBufferSubData(carrier, static_cast<GLintptr>((first + i) * sizeof(PackedVertex)),
                    static_cast<GLsizeiptr>(count * sizeof(PackedVertex)), some.data());
  }
}

void carry_indices(const Building& building, std::span<const std::uint32_t> indices,
                   std::size_t first) noexcept {
  glBindBuffer(carrier, building.indices.get());
  glBufferSubData(carrier, static_cast<GLintptr>(first * sizeof(std::uint32_t)),
                  static_cast<GLsizeiptr>(indices.size_bytes()), indices.data());
}

/// Sky and sun are read everywhere, and by two channels; how high the shade stands, by bodies. In
/// one texture of three channels drivers keep a fourth.
void carry_row(const Building& building, std::span<const std::byte> texels,
               std::size_t row) noexcept {
  constexpr std::size_t channels = Scenery::lightmap_channels, at_a_time = 1024;
  std::array<std::byte, 2 * at_a_time> light{};
  std::array<std::byte, at_a_time> shade{};
  const std::size_t width = texels.size() / channels;
  for (std::size_t left = 0; left < width; left += at_a_time) {
    const std::size_t count = std::min(at_a_time, width - left);
    for (std::size_t i = 0; i < count; ++i) {
      const std::span texel = texels.subspan((left + i) * channels, channels);
      light[2 * i] = texel[0];
      light[2 * i + 1] = texel[1];
      shade[i] = texel[2];
    }
    const auto carry = [&](Unit unit, const GlTexture& map, GLenum format, const auto& bytes) {
      bind_texture(static_cast<GLuint>(unit), map.get());
      glTexSubImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(left), static_cast<GLint>(row),
                      static_cast<GLsizei>(count), 1, format, GL_UNSIGNED_BYTE, bytes.data());
    };
    carry(Unit::LightMap, building.lightmap, GL_RG, light);
    carry(Unit::ShadeMap, building.shade_map, GL_RED, shade);
  }
}

void carry_rows(const Building& building, const Scenery& scenery, std::size_t first,
                std::size_t count) noexcept {
  const std::size_t row = std::size_t{scenery.lightmap_width} * Scenery::lightmap_channels;
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (std::size_t i = first; i < first + count; ++i)
    carry_row(building, std::span(scenery.lightmap).subspan(i * row, row), i);
}

/// Carries at most `most` of the bytes from `from` on, whole and all of one kind, and one at least;
/// returns how many.
std::size_t carry_some(const Building& building, const Scenery& scenery, std::size_t from,
                       std::size_t most) noexcept {
  const Cargo cargo(scenery);
  const auto carry = [&](std::size_t all, std::size_t size, auto carry_them) {
    const std::size_t first = from / size;
    const std::size_t count = std::min(std::max(most / size, std::size_t{1}), all / size - first);
    carry_them(first, count);
    return count * size;
  };
  if (from < cargo.vertices)
    return carry(cargo.vertices, sizeof(SceneryVertex), [&](std::size_t first, std::size_t count) {
      carry_vertices(building, std::span(scenery.vertices).subspan(first, count), first);
    });
  from -= cargo.vertices;
  if (from < cargo.indices)
    return carry(cargo.indices, sizeof(std::uint32_t), [&](std::size_t first, std::size_t count) {
      carry_indices(building, std::span(scenery.indices).subspan(first, count), first);
    });
  from -= cargo.indices;
  return carry(
      cargo.lightmap, std::size_t{scenery.lightmap_width} * Scenery::lightmap_channels,
      [&](std::size_t first, std::size_t count) { carry_rows(building, scenery, first, count); });
}

/// One of the attributes of a vertex of type V, in the buffer that is bound.
template <class V>
void describe(GLuint index, GLint count, GLenum type, std::size_t offset) noexcept {
  glEnableVertexAttribArray(index);
  glVertexAttribPointer(index, count, type, type == GL_FLOAT ? GL_FALSE : GL_TRUE,
                        static_cast<GLsizei>(sizeof(V)), buffer_offset(offset));
}

void describe_geometry(Building& building) noexcept {
  building.array = make_vertex_array();
  glBindVertexArray(building.array.get());
  glBindBuffer(GL_ARRAY_BUFFER, building.vertices.get());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, building.indices.get());
  describe<PackedVertex>(0, 3, GL_FLOAT, offsetof(PackedVertex, position));
  describe<PackedVertex>(1, 3, GL_BYTE, offsetof(PackedVertex, normal));
  describe<PackedVertex>(2, 2, GL_UNSIGNED_SHORT, offsetof(PackedVertex, uv));
  describe<PackedVertex>(3, 2, GL_UNSIGNED_BYTE, offsetof(PackedVertex, light));
  glBindVertexArray(0);
}

}  // namespace

void describe_scenery_vertices() noexcept {
  describe<SceneryVertex>(0, 3, GL_FLOAT, offsetof(SceneryVertex, position));
  describe<SceneryVertex>(1, 3, GL_FLOAT, offsetof(SceneryVertex, normal));
  describe<SceneryVertex>(2, 2, GL_FLOAT, offsetof(SceneryVertex, uv));
  static_assert(offsetof(SceneryVertex, sun) == offsetof(SceneryVertex, sky) + 1);
  describe<SceneryVertex>(3, 2, GL_UNSIGNED_BYTE, offsetof(SceneryVertex, sky));
}

bool carry_on(Building& building, const Scenery& scenery,
              std::span<const scene::TextureId> image_of) {
  constexpr std::size_t at_a_time = std::size_t{1} << 20U;
  const std::size_t all = scenery.vertices.empty() ? 0 : Cargo(scenery).count();
  if (building.carried == 0) begin(building, scenery, image_of);
  if (building.carried < all)
    building.carried += carry_some(building, scenery, building.carried, at_a_time);
  if (building.carried < all) return true;
  if (all > 0) describe_geometry(building);
  return false;
}

}  // namespace docent::gles
