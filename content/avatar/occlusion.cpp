#include "content/avatar/occlusion.h"

namespace docent::avatar {
namespace {

/// Rays: the normal and four that lean 55 degrees away from it; lengths in metres, on any body.
constexpr float lean_cosine = 0.5736F, lean_sine = 0.8192F;
constexpr std::array<float, 5> ray_length{0.025F, 0.05F, 0.09F, 0.15F, 0.24F};
/// Creases never go quite black: cloth passes light on.
constexpr float darkest = 0.25F;

/// How little a surface is hollow within a centimetre: 1 on flat and domed places.
float shallow(const DistanceField& solid, Vec3 p, Vec3 normal) {
  constexpr std::array<float, 3> rise{0.0025F, 0.005F, 0.010F};
  float least = 1;
  for (const float step : rise)
    least = std::min(least, std::max(solid(p + normal * step), 0.0F) / step);
  return glm::mix(0.45F, 1.0F, std::min(1.12F * least, 1.0F));
}

}  // namespace

Occlusion::Occlusion(const std::vector<Layer>& layers, const Box3& box, float cell)
    : low_{box.low}, cell_{cell} {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<glm::length_t>(axis);
    nodes_[axis] = static_cast<std::size_t>((box.high[a] - box.low[a]) / cell) + 2;
  }
  value_.reserve(nodes_[0] * nodes_[1] * nodes_[2]);
  for (std::size_t z = 0; z < nodes_[2]; ++z)
    for (std::size_t y = 0; y < nodes_[1]; ++y)
      for (std::size_t x = 0; x < nodes_[0]; ++x) {
        const Vec3 p =
            low_ + cell * Vec3{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
        float d = ray_length.back();
        for (const Layer& layer : layers) {
          const Vec3 outside = glm::max(layer.box.low - p, p - layer.box.high);
          if (std::max({outside.x, outside.y, outside.z}) < d) d = std::min(d, layer.solid(p));
        }
        value_.push_back(d);
      }
}

float Occlusion::distance(Vec3 p) const {
  const Vec3 last{static_cast<float>(nodes_[0] - 2), static_cast<float>(nodes_[1] - 2),
                  static_cast<float>(nodes_[2] - 2)};
  const Vec3 g = glm::clamp((p - low_) / cell_, Vec3{0}, last + 0.999F);
  const auto x = static_cast<std::size_t>(g.x);
  const auto y = static_cast<std::size_t>(g.y);
  const auto z = static_cast<std::size_t>(g.z);
  const Vec3 t = g - glm::floor(g);
  const auto row = [&](std::size_t dy, std::size_t dz) {
    const std::size_t k = ((z + dz) * nodes_[1] + y + dy) * nodes_[0] + x;
    return glm::mix(value_[k], value_[k + 1], t.x);
  };
  return glm::mix(glm::mix(row(0, 0), row(1, 0), t.y), glm::mix(row(0, 1), row(1, 1), t.y), t.z);
}

std::uint8_t Occlusion::at(const Layer& layer, Vec3 p, Vec3 normal) const {
  const Vec3 side = glm::normalize(std::abs(normal.y) < 0.9F ? glm::cross(normal, Vec3{0, 1, 0})
                                                             : glm::cross(normal, Vec3{1, 0, 0}));
  const Vec3 other = glm::cross(normal, side);
  const std::array<Vec3, 5> rays{
      normal, normal * lean_cosine + side * lean_sine, normal * lean_cosine - side * lean_sine,
      normal * lean_cosine + other * lean_sine, normal * lean_cosine - other * lean_sine};
  float open = 0;
  for (std::size_t r = 0; r < rays.size(); ++r) {
    const float rise = r == 0 ? 1.0F : lean_cosine;
    float clear = 1;
    for (const float length : ray_length)
      clear = std::min(clear, std::max(distance(p + rays[r] * length), 0.0F) / (length * rise));
    open += std::min(clear, 1.0F);
  }
  open /= static_cast<float>(rays.size());
  open *= shallow(layer.solid, p, normal);
  return static_cast<std::uint8_t>(std::lround(255 * (darkest + (1 - darkest) * open)));
}

}  // namespace docent::avatar
