/// Shows the guides for people's eyes, as a sculptor turns a figure: a sheet of each from four
/// sides, the head from near, small as on the floor plan, and all of them as black shapes.
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "content/avatar/avatar.h"
#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"
#include "content/import/motion/bvh.h"
#include "platform/gles/renderer.h"
#include "platform/headless/headless_display.h"
#include "platform/image/image.h"
#include "runtime/motion/cloth.h"
#include "runtime/scene/look.h"

namespace docent::bench {
namespace {

/// What is photographed: a mesh, and where its joints are.
struct Model {
  SkinnedMesh mesh;
  std::vector<Mat4> palette;
  Vec3 hips{0, 0.9F, 0};
  std::uint32_t look = 0;
};

/// Where the camera stands: degrees round the model, and a frame of that height about a point.
struct View {
  float yaw = 0, pitch = 6;
  Vec3 target{0, 0.87F, 0};
  float height = 1.95F, aspect = 0.5F;
};

class Studio {
 public:
  static constexpr std::uint32_t most = 1024;

  Studio() {
    auto display = headless::open_headless({most, most});
    auto renderer = gles::make_renderer();
    if (!display || !renderer) throw std::runtime_error("no headless display");
    display_ = std::move(*display);
    renderer_.emplace(std::move(*renderer));
  }

  void put(const Model& model) {
    holdings_.emplace();
    holdings_->set_body(model.mesh, scene::levels_of(model.mesh));
    list_ = {};
    list_.palette = model.palette;
    list_.focus_radius = 100;
    scene::AvatarDraw avatar;
    avatar.look = model.look;
    avatar.centre = model.hips;
    avatar.feet[0] = {0.1F, 0, 0};
    avatar.feet[1] = {-0.1F, 0, 0};
    list_.avatars.push_back(avatar);
  }

  /// Draws into a picture of the sheet; `pixels` high.
  void shoot(const View& view, std::uint32_t pixels, Pixels& sheet, std::uint32_t x,
             std::uint32_t y) {
    constexpr float fov = 0.22F;  // radians: a long lens
    // The picture is the middle of a square one.
    const float scale = static_cast<float>(most) / static_cast<float>(pixels);
    const float distance = 0.5F * view.height / std::tan(0.5F * fov);
    const float yaw = glm::radians(view.yaw), pitch = glm::radians(view.pitch);
    const Vec3 eye = view.target + distance * Vec3{std::sin(yaw) * std::cos(pitch), std::sin(pitch),
                                                   std::cos(yaw) * std::cos(pitch)};
    list_.camera.eye = eye;
    list_.camera.target = view.target;
    list_.camera.view = glm::lookAt(eye, view.target, Vec3(0, 1, 0));
    const float half = 0.05F * std::tan(0.5F * fov) * scale;
    list_.camera.projection = glm::frustum(-half, half, -half, half, 0.05F, 60.0F);
    renderer_->draw(list_, *holdings_, display_->target());
    Pixels picture;
    display_->read_back(picture);
    const auto width = static_cast<std::uint32_t>(static_cast<float>(pixels) * view.aspect);
    for (std::uint32_t row = 0; row < pixels; ++row)
      for (std::uint32_t column = 0; column < width; ++column) {
        const std::size_t from =
            4 * (std::size_t{(most - pixels) / 2 + row} * most + (most - width) / 2 + column);
        const std::size_t to = 4 * (std::size_t{y + row} * sheet.width + x + column);
        if (x + column >= sheet.width || y + row >= sheet.height) continue;
        std::copy_n(picture.rgba.begin() + static_cast<std::ptrdiff_t>(from), 4,
                    sheet.rgba.begin() + static_cast<std::ptrdiff_t>(to));
      }
  }

 private:
  std::unique_ptr<headless::HeadlessDisplay> display_;
  std::optional<gles::Renderer> renderer_;
  std::optional<gles::Holdings> holdings_;
  scene::DrawList list_;
};

Pixels blank(std::uint32_t width, std::uint32_t height) {
  return {width, height, std::vector<std::byte>(std::size_t{4} * width * height, std::byte{255})};
}

std::vector<Mat4> posed(const SkinnedMesh& mesh, const Skeleton& skeleton, const MotionClip& clip,
                        std::size_t frame) {
  std::vector<Mat4> world, palette;
  const Vec3 root{0, clip.root[frame].y, 0};
  for (std::size_t j = 0; j < skeleton.joint.size(); ++j) {
    const Mat4 turn = glm::mat4_cast(clip.rotation[frame * clip.joint_count + j]);
    const Joint& joint = skeleton.joint[j];
    world.push_back(joint.parent == JointIndex::None
                        ? glm::translate(Mat4(1.0F), root) * turn
                        : world[index_of(joint.parent)] * glm::translate(Mat4(1.0F), joint.offset) *
                              turn);
    palette.push_back(world[j] * mesh.inverse_bind[j]);
  }
  return palette;
}

void hang_clothes(Model& model) {
  const Cloth& cloth = model.mesh.cloth;
  model.palette.resize(matrices_of(model.mesh), Mat4(1));
  motion::ClothMotion motion = motion::make_cloth_motion(cloth.node.size());
  motion::hang({cloth.node, cloth.collider}, model.palette, motion);
}

struct Options {
  std::string kind = "body", bvh;
  std::filesystem::path out = "turntable.png";
  std::vector<std::uint32_t> figures{0};
  std::int64_t frame = -1;
  float x = 0, y = 1.60F, z = 0.05F, height = 0.32F;
};

void body_sheet(Studio& studio, Pixels& sheet, std::uint32_t y) {
  std::uint32_t x = 0;
  for (const float yaw : {0.0F, 40.0F, 90.0F, 180.0F}) {
    studio.shoot({.yaw = yaw}, 900, sheet, x, y);
    x += 450;
  }
}

void near_sheet(Studio& studio, const Options& options, std::uint32_t look, Pixels& sheet,
                std::uint32_t y) {
  const float scale = scene::looks[look].height;
  std::uint32_t x = 0;
  for (const float yaw : {0.0F, 40.0F, 90.0F, 200.0F}) {
    studio.shoot({.yaw = yaw,
                  .target = {options.x, options.y * scale, options.z},
                  .height = options.height,
                  .aspect = 1},
                 900, sheet, x, y);
    x += 900;
  }
}

int run(int argc, char** argv) {
  CLI::App app{"Shows the guides from all sides"};
  Options options;
  app.add_option("--kind", options.kind, "body, near or row");
  app.add_option("--figure", options.figures, "which");
  app.add_option("--frame", options.frame, "of the shipped walk; -1: as modelled");
  app.add_option("--bvh", options.bvh, "another skeleton");
  app.add_option("--x", options.x, "metres: what is seen from near");
  app.add_option("--y", options.y, "metres");
  app.add_option("--z", options.z, "metres");
  app.add_option("--height", options.height, "metres");
  app.add_option("--out", options.out, "picture");
  CLI11_PARSE(app, argc, argv);

  Skeleton skeleton = gait::gait_skeleton();
  MotionClip clip;
  if (!options.bvh.empty()) {
    auto recorded = import::read_bvh(options.bvh);
    skeleton = recorded.skeleton;
    clip = recorded.clip;
  } else if (options.frame >= 0) {
    clip = gait::make_gait_clip(gait::default_clips()[1]);
  }
  Studio studio;
  Pixels row = blank(static_cast<std::uint32_t>(options.figures.size()) * 200, 480);
  const auto count = static_cast<std::uint32_t>(options.figures.size());
  Pixels sheet = blank(options.kind == "body" ? 1800 : 3600, 900 * count);
  std::uint32_t x = 0, y = 0;
  for (const std::uint32_t figure : options.figures) {
    Model model;
    model.mesh = avatar::make_avatar(skeleton, avatar::figures.at(figure));
    model.look = figure;
    model.palette.assign(model.mesh.inverse_bind.size(), Mat4(1));
    if (options.frame >= 0)
      model.palette = posed(model.mesh, skeleton, clip, static_cast<std::size_t>(options.frame));
    hang_clothes(model);
    fmt::print("figure {}: {} triangles, {} vertices\n", figure, model.mesh.indices.size() / 3,
               model.mesh.vertices.size());
    studio.put(model);
    if (options.kind == "row") {
      studio.shoot({.yaw = 25, .aspect = 0.5F}, 400, row, x, 0);
      studio.shoot({.yaw = 25, .aspect = 1}, 40, row, x + 20, 420);
      studio.shoot({.yaw = 160, .aspect = 1}, 40, row, x + 80, 420);
      x += 200;
      continue;
    }
    if (options.kind == "body")
      body_sheet(studio, sheet, y);
    else
      near_sheet(studio, options, figure, sheet, y);
    y += 900;
  }
  const Pixels& shown = options.kind == "row" ? row : sheet;
  return image::write_png(options.out, image::shrink(shown, 2000)) ? 0 : 3;
}

}  // namespace
}  // namespace docent::bench

int main(int argc, char** argv) {
  return docent::bench::run(argc, argv);
}
