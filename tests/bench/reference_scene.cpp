#include "tests/bench/reference_scene.h"

#include <cmath>
#include <cstdint>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <vector>

#include "runtime/model/geometry/vec2.h"

namespace docent::bench {
namespace {

constexpr int columns = 200, rows = 125;  // of squares, two triangles each
constexpr GLsizei shadow_side = 1024;

constexpr std::string_view vertex = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 normal_in;
uniform mat4 view;
uniform mat4 light;
out vec3 normal;
out vec3 in_light;
void main() {
  normal = normal_in;
  in_light = 0.5 * (light * vec4(place, 1.0)).xyz + 0.5;
  gl_Position = view * vec4(place, 1.0);
}
)";
constexpr std::string_view lit_fragment = R"(
in vec3 normal;
in vec3 in_light;
out vec4 colour;
uniform highp sampler2DShadow image;
void main() {
  vec3 n = normalize(normal);
  float share = texture(image, vec3(in_light.xy, in_light.z - 0.002));
  vec3 light = vec3(0.3) + vec3(1.0, 0.95, 0.85) * share * max(dot(n, vec3(0.48, 0.8, 0.36)), 0.0);
  colour = vec4(pow(vec3(0.7, 0.6, 0.5) * light, vec3(1.0 / 2.2)), 1.0);
}
)";
constexpr std::string_view depth_fragment = "void main() {}\n";

float height_at(float x, float z) {
  return 0.5F * std::sin(1.7F * x) * std::cos(1.3F * z) + 0.2F * std::sin(5 * x + 3 * z);
}

/// Hills over 24 by 16 metres: more than the picture shows.
std::vector<float> hills() {
  std::vector<float> all;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column <= columns; ++column) {
      constexpr float step = 0.01F;
      const float x = 24.0F * static_cast<float>(column) / columns - 12;
      const float z = 16.0F * static_cast<float>(row) / rows - 8;
      const float y = height_at(x, z);
      const glm::vec3 normal = glm::normalize(
          glm::vec3((y - height_at(x + step, z)) / step, 1, (y - height_at(x, z + step)) / step));
      all.insert(all.end(), {x, y, z, normal.x, normal.y, normal.z});
    }
  return all;
}

std::vector<std::uint32_t> triangles_of_hills() {
  std::vector<std::uint32_t> all;
  for (std::uint32_t row = 0; row < rows; ++row)
    for (std::uint32_t column = 0; column < columns; ++column) {
      const std::uint32_t a = row * (columns + 1) + column, b = a + columns + 1;
      all.insert(all.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  return all;
}

glm::mat4 light_view() {
  return glm::ortho(-14.0F, 14.0F, -12.0F, 12.0F, 1.0F, 40.0F) *
         glm::lookAt(20.0F * glm::vec3(0.48F, 0.8F, 0.36F), glm::vec3(0), glm::vec3(0, 1, 0));
}

gles::GlRenderbuffer buffer_of(GLenum format, PixelSize size, int samples) {
  gles::GlRenderbuffer buffer = gles::make_renderbuffer();
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.get());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples > 1 ? samples : 0, format,
                                   static_cast<GLsizei>(size.width),
                                   static_cast<GLsizei>(size.height));
  return buffer;
}

}  // namespace

int ReferenceScene::triangles() const noexcept {
  return 2 * columns * rows;
}

Result<ReferenceScene> ReferenceScene::make(PixelSize size, int samples) {
  auto lit = gles::link_program("reference", {vertex}, {lit_fragment});
  if (!lit) return std::unexpected(lit.error());
  auto depth = gles::link_program("reference depth", {vertex}, {depth_fragment});
  if (!depth) return std::unexpected(depth.error());
  ReferenceScene scene;
  scene.size_ = size;
  scene.lit_ = std::move(*lit);
  scene.depth_ = std::move(*depth);
  scene.array_ = gles::make_vertex_array();
  scene.vertices_ = gles::make_buffer();
  scene.indices_ = gles::make_buffer();
  const auto places = hills();
  const auto corners = triangles_of_hills();
  glBindVertexArray(scene.array_.get());
  glBindBuffer(GL_ARRAY_BUFFER, scene.vertices_.get());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(places.size() * sizeof(float)),
               places.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, scene.indices_.get());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(corners.size() * 4), corners.data(),
               GL_STATIC_DRAW);
  for (GLuint i = 0; i < 2; ++i) {
    glEnableVertexAttribArray(i);
    glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 24, gles::buffer_offset(std::size_t{i} * 12));
  }
  glBindVertexArray(0);

  scene.shadow_ = gles::make_texture();
  glBindTexture(GL_TEXTURE_2D, scene.shadow_.get());
  glTexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, shadow_side, shadow_side);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  scene.to_shadow_ = gles::make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, scene.to_shadow_.get());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, scene.shadow_.get(),
                         0);
  scene.colour_ = buffer_of(GL_RGBA8, size, samples);
  scene.depth_buffer_ = buffer_of(GL_DEPTH_COMPONENT24, size, samples);
  scene.shown_ = buffer_of(GL_RGBA8, size, 1);
  scene.to_samples_ = gles::make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, scene.to_samples_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            scene.colour_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER,
                            scene.depth_buffer_.get());
  scene.to_picture_ = gles::make_framebuffer();
  glBindFramebuffer(GL_FRAMEBUFFER, scene.to_picture_.get());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                            scene.shown_.get());
  return scene;
}

void ReferenceScene::draw_shadow_map() const noexcept {
  const glm::mat4 light = light_view();
  glBindFramebuffer(GL_FRAMEBUFFER, to_shadow_.get());
  glViewport(0, 0, shadow_side, shadow_side);
  glClear(GL_DEPTH_BUFFER_BIT);
  depth_.use();
  glUniformMatrix4fv(depth_["view"], 1, GL_FALSE, glm::value_ptr(light));
  glUniformMatrix4fv(depth_["light"], 1, GL_FALSE, glm::value_ptr(light));
  glDrawElements(GL_TRIANGLES, 3 * triangles(), GL_UNSIGNED_INT, nullptr);
}

void ReferenceScene::draw_picture() const noexcept {
  const auto width = static_cast<GLsizei>(size_.width), height = static_cast<GLsizei>(size_.height);
  const float aspect = static_cast<float>(size_.width) / static_cast<float>(size_.height);
  const glm::mat4 light = light_view();
  const glm::mat4 view = glm::perspective(0.52F, aspect, 1.0F, 60.0F) *
                         glm::lookAt(glm::vec3(0, 14, 12), glm::vec3(0, 0, 0), glm::vec3(0, 1, 0));
  glBindFramebuffer(GL_FRAMEBUFFER, to_samples_.get());
  glViewport(0, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  lit_.use();
  glUniformMatrix4fv(lit_["view"], 1, GL_FALSE, glm::value_ptr(view));
  glUniformMatrix4fv(lit_["light"], 1, GL_FALSE, glm::value_ptr(light));
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(gles::Unit::Image));
  glBindTexture(GL_TEXTURE_2D, shadow_.get());
  glDrawElements(GL_TRIANGLES, 3 * triangles(), GL_UNSIGNED_INT, nullptr);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, to_samples_.get());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to_picture_.get());
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

void ReferenceScene::draw() const noexcept {
  glEnable(GL_DEPTH_TEST);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
  glEnable(GL_CULL_FACE);
  glBindVertexArray(array_.get());
  draw_shadow_map();
  draw_picture();
  glBindVertexArray(0);
}

}  // namespace docent::bench
