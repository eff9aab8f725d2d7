#include "content/object/stand_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace docent::object {
namespace {

using import::object::UpAxis;

Vec3 turned(Vec3 p, UpAxis up) {
  return up == UpAxis::Y ? p : Vec3{p.x, p.z, -p.y};
}

/// How much of its ground plan an object stands on, of 1: the box of all that is near the floor.
float foot_share(const Shape& shape, UpAxis up) {
  constexpr float near = 0.02F;
  Vec3 low{0}, high{0}, foot_low{0}, foot_high{0};
  bool is_first = true;
  for (const std::uint32_t i : shape.indices) {
    const Vec3 p = turned(shape.vertices[i].position, up);
    low = is_first ? p : glm::min(low, p);
    high = is_first ? p : glm::max(high, p);
    is_first = false;
  }
  is_first = true;
  for (const std::uint32_t i : shape.indices) {
    const Vec3 p = turned(shape.vertices[i].position, up);
    if (p.y > low.y + near * (high.y - low.y)) continue;
    foot_low = is_first ? p : glm::min(foot_low, p);
    foot_high = is_first ? p : glm::max(foot_high, p);
    is_first = false;
  }
  const auto area = [](Vec3 a, Vec3 b) { return (b.x - a.x) * (b.z - a.z); };
  const float all = area(low, high);
  return all > 0 ? area(foot_low, foot_high) / all : 1;
}

UpAxis up_of(const import::object::ObjectFile& file, const ObjectWish& wish, const Shape& shape) {
  if (wish.up) return *wish.up;
  if (file.says_up) return file.up;
  const UpAxis other = file.up == UpAxis::Y ? UpAxis::Z : UpAxis::Y;
  constexpr float point = 0.15F, broader = 3;
  const float usual = foot_share(shape, file.up);
  return usual < point && foot_share(shape, other) > broader * usual ? other : file.up;
}

struct Unit {
  float metres = 1;
  std::string_view name = "metres";
};

Unit unit_of(float largest) {
  constexpr float largest_object = 5, smallest_object = 0.02F;
  if (largest <= largest_object) return {};
  if (largest * 0.001F >= smallest_object) return {0.001F, "millimetres"};
  return {0.01F, "centimetres"};
}

}  // namespace

void stand_up(const import::object::ObjectFile& file, const ObjectWish& wish, Shape& shape,
              std::vector<std::string>& notes) {
  const UpAxis up = up_of(file, wish, shape);
  for (ShapeVertex& v : shape.vertices) v.position = turned(v.position, up);
  const Box box = box_of(shape);
  const Vec3 size = box.size();
  float scale = 1;
  if (wish.height && size.y > 0) {
    scale = static_cast<float>(*wish.height) / size.y;
  } else {
    const Unit unit = unit_of(std::max({size.x, size.y, size.z}));
    scale = unit.metres;
    if (file.is_in_metres && scale != 1)
      notes.push_back(
          fmt::format("it would be {:.4g} m large, so its numbers are taken as {}: it "
                      "is {:.3g} m high",
                      std::max({size.x, size.y, size.z}), unit.name, size.y * scale));
    else if (!file.is_in_metres)
      notes.push_back(fmt::format("it says no unit: taken as {}, with {} up, it is {:.3g} m high",
                                  unit.name, up == UpAxis::Y ? "y" : "z", size.y * scale));
  }
  const Vec3 foot{(box.low.x + box.high.x) / 2, box.low.y, (box.low.z + box.high.z) / 2};
  for (ShapeVertex& v : shape.vertices) v.position = scale * (v.position - foot) + Vec3{0.0F};
}

}  // namespace docent::object
