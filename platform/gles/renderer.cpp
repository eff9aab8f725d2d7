#include "platform/gles/renderer.h"

#include <algorithm>
#include <array>
#include <utility>

#include "platform/gles/avatar_pass.h"
#include "platform/gles/holdings_parts.h"
#include "platform/gles/object_pass.h"
#include "platform/gles/program.h"
#include "platform/gles/quad_pass.h"
#include "platform/gles/scene_buffer.h"
#include "platform/gles/scenery_pass.h"
#include "platform/gles/shaders.h"
#include "platform/gles/way_pass.h"
#include "runtime/model/motion/skeleton.h"

namespace docent::gles {
namespace {

/// Block `Frame` of frame.glsl, in std140 layout.
struct FrameBlock {
  Mat4 view_projection;
  Vec4 eye, sun, focus, goal, paper, lightmap, sun_colour, sky_colour, bounce_colour, lamp;
};

constexpr float light_of_goal = 0.16F;

Vec4 colour_of(const scene::Colour& c) noexcept {
  return {c.r, c.g, c.b, c.a};
}

Vec4 place_on_floor(Vec2 place, float radius, float amount) noexcept {
  const Vec3 world = to_world(place);
  return {world.x, world.z, radius, amount};
}

FrameBlock frame_block(const scene::DrawList& list, const Building* building) noexcept {
  FrameBlock frame{};
  frame.view_projection = list.camera.projection * list.camera.view;
  frame.eye = Vec4(list.camera.eye, 1);
  frame.focus = place_on_floor(list.focus, list.focus_radius, list.fade);
  frame.goal = place_on_floor(list.goal, list.goal_radius, light_of_goal);
  frame.paper = colour_of(list.light.paper);
  frame.sun = Vec4(0, 1, 0, 0);
  frame.sun_colour = colour_of(list.light.sun);
  frame.sky_colour = colour_of(list.light.sky);
  frame.bounce_colour = colour_of(list.light.bounce);
  frame.lamp = colour_of(list.light.lamp);
  if (building) {
    const Scenery& scenery = building->scenery;
    const Vec2 size = scenery.lightmap_max - scenery.lightmap_min;
    // The lightmap's rows run north, world z runs south.
    frame.lightmap = {static_cast<float>(scenery.lightmap_min.x),
                      static_cast<float>(-scenery.lightmap_min.y), static_cast<float>(1 / size.x),
                      static_cast<float>(-1 / size.y)};
    frame.sun = Vec4(scenery.sun, building->floor_height);
  }
  return frame;
}

Extent extent_of(const scene::Rect& rect) noexcept {
  if (rect.width <= 0) return {};
  return {.left = 2 * rect.x - 1,
          .right = 2 * (rect.x + rect.width) - 1,
          .low = 1 - 2 * (rect.y + rect.height),
          .high = 1 - 2 * rect.y,
          .outside = 0};
}

}  // namespace

using Held = Holdings::Parts;

struct Renderer::Parts {
  explicit Parts(const RendererOptions& options)
      : buffer(options.samples, options.buffer_bytes),
        frame(make_buffer()),
        array(make_vertex_array()) {}

  Result<void> compile();
  void prepare(const scene::DrawList& list, const Held& held, Vec3 sun, PixelSize size) noexcept;
  /// Where the picture has to be drawn anew: of the model, and of the interface, which often lie
  /// far from each other, as a video and a guide who breathes do. One is empty where both together
  /// are no larger.
  using Regions = std::array<Region, 2>;
  Regions regions_of_change(const scene::DrawList& list, const scene::Change& change, Vec3 sun,
                            double floor, PixelSize size) noexcept;
  /// Returns what of the picture it drew.
  Regions draw_model(const scene::DrawList& list, const Held& held, GLuint framebuffer,
                     PixelSize size, const scene::Change& change) noexcept;
  void draw_strip(const scene::DrawList& list, const Held& held, SceneBuffer::Rows rows) noexcept;
  void draw_interface(const scene::DrawList& list, const Held& held, GLuint framebuffer,
                      PixelSize size, const Region& region) noexcept;
  void copy_to_panel(const RenderTarget& target) noexcept;

  SceneBuffer buffer;
  Picture picture;
  SceneryPass scenery;
  ObjectPass objects;
  AvatarPass avatars;
  WayPass way;
  QuadPass quads;
  Program copy;
  GLint quarter_turns = -1, shift = -1;
  GlBuffer frame;
  GlVertexArray array;
  /// What there is a picture of, and where.
  struct Drawn {
    const Holdings* holdings = nullptr;
    GLuint framebuffer = 0;
    PixelSize size;
    bool operator==(const Drawn&) const = default;
  };
  Drawn drawn;
};

Result<void> Renderer::Parts::compile() {
  for (auto made :
       {scenery.compile(), objects.compile(), avatars.compile(), way.compile(), quads.compile()})
    if (!made) return made;
  auto copier = link_program("copy", {shaders::copy_vert}, {shaders::copy_frag});
  if (!copier) return std::unexpected(copier.error());
  copy = std::move(*copier);
  quarter_turns = copy["quarter_turns"];
  shift = copy["shift"];
  glReleaseShaderCompiler();  // nothing is compiled from source any more
  glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(FrameBlock), nullptr, GL_STREAM_DRAW);
  return {};
}

/// Front to back: what hides the floor comes before it. Then what lies on the floor, then glass.
void Renderer::Parts::draw_strip(const scene::DrawList& list, const Held& held,
                                 SceneBuffer::Rows rows) noexcept {
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClearColor(list.light.paper.r, list.light.paper.g, list.light.paper.b, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  avatars.draw_bodies(rows);
  objects.draw(list, held.objects);
  const Building* building = held.building(list.floor);
  if (building) {
    scenery.draw_solids(*building, list.highlighted_exhibit, held.textures);
    scenery.draw_floors(*building);
  }

  glDepthMask(GL_FALSE);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(-1, -2);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  way.draw(list);
  glBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ONE);
  avatars.draw_shadows(rows);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  if (building) scenery.draw_glass(*building);
  glDepthMask(GL_TRUE);
}

void Renderer::Parts::prepare(const scene::DrawList& list, const Held& held, Vec3 sun,
                              PixelSize size) noexcept {
  const Building* building = held.building(list.floor);
  way.prepare(list);
  scenery.prepare(list.walls, list.leaves);
  avatars.prepare(list, held.body, sun, size);
  bind_texture(static_cast<GLuint>(Unit::LightMap), building ? building->lightmap.get() : 0);
  buffer.fit(size);
}

Renderer::Parts::Regions Renderer::Parts::regions_of_change(const scene::DrawList& list,
                                                            const scene::Change& change, Vec3 sun,
                                                            double floor, PixelSize size) noexcept {
  Region model = avatars.moved(list, change, sun, size);
  if (change.everything)
    return {Region{0, 0, static_cast<GLint>(size.width), static_cast<GLint>(size.height)}, {}};
  if (change.ways) model.include(region_of(WayPass::extent_of_ribbons(list, floor), size));
  const Region interface = region_of(extent_of(change.interface), size);
  Region both = model;
  both.include(interface);
  // What is blended must not be drawn twice.
  if (model.overlaps(interface) || both.area() <= model.area() + interface.area())
    return {both, {}};
  return {model, interface};
}

Renderer::Parts::Regions Renderer::Parts::draw_model(const scene::DrawList& list, const Held& held,
                                                     GLuint framebuffer, PixelSize size,
                                                     const scene::Change& change) noexcept {
  const Building* building = held.building(list.floor);
  const FrameBlock block = frame_block(list, building);
  glBindBuffer(GL_UNIFORM_BUFFER, frame.get());
  glBufferSubData(GL_UNIFORM_BUFFER, 0, sizeof block, &block);
  glBindBufferBase(GL_UNIFORM_BUFFER, static_cast<GLuint>(Block::Frame), frame.get());
  prepare(list, held, Vec3(block.sun), size);
  const Regions regions =
      regions_of_change(list, change, Vec3(block.sun), building ? building->floor_height : 0, size);
  for (const Region& region : regions)
    for (std::uint32_t strip = 0; strip < buffer.strips(); ++strip) {
      const Region part = buffer.part(strip, region);
      if (part.is_empty()) continue;
      if (!change.everything) glEnable(GL_SCISSOR_TEST);
      buffer.begin(strip, part);
      draw_strip(list, held, buffer.rows(part));
      buffer.resolve(strip, part, framebuffer);
    }
  return regions;
}

void Renderer::Parts::draw_interface(const scene::DrawList& list, const Held& held,
                                     GLuint framebuffer, PixelSize size,
                                     const Region& region) noexcept {
  if (region.is_empty()) return;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, static_cast<GLsizei>(size.width), static_cast<GLsizei>(size.height));
  glEnable(GL_SCISSOR_TEST);
  glScissor(region.left, region.low, region.right - region.left, region.high - region.low);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  quads.draw(list.quads, size, held.textures);
  glDisable(GL_SCISSOR_TEST);
}

void Renderer::Parts::copy_to_panel(const RenderTarget& target) noexcept {
  const bool sideways =
      target.rotation == Rotation::Quarter || target.rotation == Rotation::ThreeQuarters;
  const auto width = static_cast<GLsizei>(sideways ? target.size.height : target.size.width);
  const auto height = static_cast<GLsizei>(sideways ? target.size.width : target.size.height);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer);
  glViewport(0, 0, width, height);
  glDisable(GL_BLEND);
  copy.use();
  glUniform1i(quarter_turns, static_cast<GLint>(target.rotation));
  // The picture's y runs up.
  glUniform2f(shift, static_cast<float>(target.shift_x) / static_cast<float>(target.size.width),
              -static_cast<float>(target.shift_y) / static_cast<float>(target.size.height));
  bind_texture(static_cast<GLuint>(Unit::Image), picture.texture());
  glBindVertexArray(array.get());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

Renderer::Renderer(std::unique_ptr<Parts> parts) noexcept : parts_(std::move(parts)) {}
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;
Renderer::~Renderer() = default;

void Renderer::draw(const scene::DrawList& list, const Holdings& holdings,
                    const RenderTarget& target, const scene::Change& change) noexcept {
  if (target.size.width == 0 || target.size.height == 0) return;
  const bool direct = target.encoding == Encoding::Srgb;
  if (!direct) parts_->picture.fit(target.size);
  const GLuint framebuffer = direct ? target.framebuffer : parts_->picture.framebuffer();
  const Parts::Drawn now{&holdings, framebuffer, target.size};
  const bool is_there = std::exchange(parts_->drawn, now) == now;
  for (const Region& region : parts_->draw_model(list, holdings.parts(), framebuffer, target.size,
                                                 is_there ? change : scene::Change{}))
    parts_->draw_interface(list, holdings.parts(), framebuffer, target.size, region);
  if (!direct) parts_->copy_to_panel(target);
}

/// A driver that compiles shaders for the state they are used in does so here and not in a frame.
void Renderer::warm_up(Holdings& holdings, const RenderTarget& target) {
  // Not 1 by 1: where sides are powers of two llvmpipe has code of its own.
  const Pixels dot{3, 3, std::vector<std::byte>(36, std::byte{255})};
  const std::vector<std::uint8_t> coverage(9, 255);
  constexpr auto image = static_cast<scene::TextureId>(Textures::most);
  constexpr auto text = static_cast<scene::TextureId>(Textures::most - 1);
  holdings.add_image(image, dot);
  holdings.add_text(text, 3, 3, coverage);
  scene::DrawList list;
  list.camera.eye = {0, 10, 0};
  list.walls.any = true;
  list.walls.level.resize(std::size_t{scene::WallLevels::side} * scene::WallLevels::side);
  list.leaves.emplace_back();
  list.ribbon_point = {{0, 0}, {1, 0}};
  list.ribbons.emplace_back();
  list.ribbons.back().count = 2;
  list.ribbons.back().length = 1;
  list.markers.emplace_back();
  list.objects.emplace_back();
  list.palette.assign(most_joints, Mat4(1));
  list.avatars.emplace_back();
  for (const scene::QuadFill fill :
       {scene::QuadFill::Solid, scene::QuadFill::Text, scene::QuadFill::Image}) {
    scene::Quad quad;
    quad.rect = {0, 0, 1, 1};
    quad.fill = fill;
    quad.texture = fill == scene::QuadFill::Text ? text : image;
    list.quads.push_back(quad);
  }
  draw(list, holdings, target);
  glFinish();
  parts_->drawn = {};
  holdings.release(image);
  holdings.release(text);
}

Result<Renderer> make_renderer(const RendererOptions& options) {
  auto parts = std::make_unique<Renderer::Parts>(options);
  if (auto compiled = parts->compile(); !compiled) return std::unexpected(compiled.error());
  return Renderer(std::move(parts));
}

}  // namespace docent::gles
