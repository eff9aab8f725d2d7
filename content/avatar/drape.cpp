#include "content/avatar/drape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "content/avatar/hair.h"

// Measures with `s` are metres on a person of 1.70 m, shaped for this avatar; `s` scales them.

namespace docent::avatar {
namespace {

/// Shorter garments keep their shape.
constexpr float shortest = 0.10F;
/// Chains round a skirt, degrees from the front: close together where thighs push.
constexpr std::array chain_degrees{-150.0F, -112.0F, -72.0F, -34.0F, 0.0F,
                                   34.0F,   72.0F,   112.0F, 150.0F, 180.0F};
constexpr float row_length = 0.19F;
constexpr std::size_t most_rows = 3;

/// The outside of a solid, from `start` outwards.
template <typename Solid>
Vec3 outside_of(Solid solid, Vec3 start, Vec3 outward) {
  float out = 0.45F;  // metres: sphere tracing from beyond the body
  for (int step = 0; step < 40; ++step) out -= solid(start + out * outward);
  return start + std::max(out, 0.0F) * outward;
}

/// Between which two chains a point is, and how far from the first.
struct Between {
  std::size_t first, second;
  float share;
};

Between between(const std::vector<float>& marks, float at, bool round) {
  const std::size_t last = marks.size() - 1;
  if (at <= marks.front() || at >= marks.back()) {
    if (!round) return at <= marks.front() ? Between{0, 0, 0} : Between{last, last, 0};
    const float whole = 2 * std::numbers::pi_v<float>;
    const float gap = marks.front() + whole - marks.back();
    const float past = at >= marks.back() ? at - marks.back() : at + whole - marks.back();
    return {last, 0, past / gap};
  }
  std::size_t k = 1;
  while (at > marks[k]) ++k;
  return {k - 1, k, (at - marks[k - 1]) / (marks[k] - marks[k - 1])};
}

void add_sheet(const Sheet& sheet, std::vector<ClothNode>& nodes) {
  if (sheet.size() == 0) return;
  const std::size_t first = nodes.size(), rows = sheet.height.size(), chains = sheet.across.size();
  const auto index = [&](std::size_t chain, std::size_t row) {
    return static_cast<std::uint8_t>(first + chain * rows + row);
  };
  for (std::size_t chain = 0; chain < chains; ++chain)
    for (std::size_t row = 0; row < rows; ++row) {
      const std::size_t at = chain * rows + row;
      ClothNode node{.place = sheet.place[at], .outward = sheet.outward[at]};
      if (row > 0) node.above = index(chain, row - 1);
      if (sheet.round || chain > 0) node.right = index((chain + chains - 1) % chains, row);
      if (sheet.round || chain + 1 < chains) node.left = index((chain + 1) % chains, row);
      // The seam below the waist is almost firm; lower down cloth is free.
      const bool free = row > 0;
      node.stiffness = free ? sheet.stiffness : 2.5F * sheet.stiffness;
      node.damping = free ? 6.5F : 9.0F;
      node.drag = free ? 1.0F : 0.5F;
      node.tension = sheet.tension;
      nodes.push_back(node);
    }
}

}  // namespace

Sheet skirt_of(const BodyShape& body) {
  const float s = body.scale;
  const float length = body.hip_height - body.hem;
  if (length < shortest * s) return {};
  Sheet sheet{.round = true, .stiffness = 150, .tension = 60};
  sheet.top = body.hip_height + 0.02F * s;
  sheet.whole = body.hip_height - 0.06F * s;
  const auto wanted = static_cast<std::size_t>(std::lround(length / (row_length * s)));
  const std::size_t rows = std::clamp(wanted, std::size_t{1}, most_rows);
  const float lowest = body.hem + 0.012F * s;
  // The first row is where thighs push most, just below the hips.
  const float highest = std::max(body.hip_height - row_length * s, lowest);
  for (std::size_t row = 0; row < rows; ++row)
    sheet.height.push_back(
        glm::mix(highest, lowest,
                 rows == 1 ? 1.0F : static_cast<float>(row) / static_cast<float>(rows - 1)));
  for (const float degrees : chain_degrees) {
    const float angle = glm::radians(degrees);
    const Vec3 outward{std::sin(angle), 0, std::cos(angle)};
    sheet.across.push_back(angle);
    for (const float height : sheet.height) {
      sheet.outward.push_back(outward);
      sheet.place.push_back(
          outside_of([&](Vec3 p) { return coat_trunk(body, p, 0); }, {0, height, 0}, outward));
    }
  }
  return sheet;
}

Sheet long_hair_of(const BodyShape& body) {
  if (body.figure.hair != Hair::Long) return {};
  const float s = body.scale;
  Sheet sheet{.stiffness = 70, .tension = 50};
  sheet.top = body.skull.y - 0.075F * s;
  sheet.height = {body.skull.y - 0.165F * s, body.skull.y - 0.255F * s};
  for (const float x : {-0.075F, -0.040F, 0.0F, 0.040F, 0.075F}) {
    sheet.across.push_back(x * s);
    const Vec3 outward = glm::normalize(Vec3{x, 0, -0.085F});
    for (const float height : sheet.height) {
      sheet.outward.push_back(outward);
      sheet.place.push_back(outside_of([&](Vec3 p) { return hair(body, p); },
                                       {0.6F * x * s, height, body.skull.z - 0.07F * s}, outward));
    }
  }
  return sheet;
}

float swinging_share(const Sheet& sheet, Vec3 p) {
  if (sheet.size() == 0) return 0;
  return 1 - smoothstep(std::max(sheet.height.front(), sheet.whole), sheet.top, p.y);
}

void share_out(const Sheet& sheet, Vec3 p, float share, std::span<float> nodes) {
  if (sheet.size() == 0) return;
  const float at = sheet.round ? std::atan2(p.x, p.z) : p.x;
  const Between chain = between(sheet.across, at, sheet.round);
  const std::size_t rows = sheet.height.size();
  std::size_t row = 0;
  while (row + 1 < rows && p.y < sheet.height[row + 1]) ++row;
  const std::size_t next = std::min(row + 1, rows - 1);
  float down = 0;
  if (next > row)
    down = std::clamp((sheet.height[row] - p.y) / (sheet.height[row] - sheet.height[next]), 0.0F,
                      1.0F);
  for (const auto& [k, part] :
       {std::pair{chain.first, 1 - chain.share}, std::pair{chain.second, chain.share}}) {
    nodes[k * rows + row] += share * part * (1 - down);
    nodes[k * rows + next] += share * part * down;
  }
}

std::vector<ClothCollider> colliders_of(const BodyShape& body, const ClothJoints& joints) {
  const float s = body.scale;
  const float w = s * body.cut.legs;
  // Half of the cloth between two chains sags onto the limb: that much more.
  const float room = 0.0135F * s;
  // Of a robe, which is wide, more does.
  const float shin_room = (body.cut.hem < -0.2F ? 0.030F : 0.0135F) * s;
  std::vector<ClothCollider> all;
  for (const Side side : both_sides) {
    const LimbPoints& limb = body.limb(side);
    const std::size_t i = index_of(side);
    all.push_back({.joint = static_cast<std::uint8_t>(joints.thigh[i]),
                   .from = limb.hip - Vec3{0, 0.02F * s, 0},
                   .to = limb.knee,
                   .from_radius = 0.080F * s + room,
                   .to_radius = 0.062F * w + room});
    all.push_back({.joint = static_cast<std::uint8_t>(joints.shin[i]),
                   .from = limb.knee,
                   .to = limb.ankle,
                   .from_radius = 0.062F * w + shin_room,
                   .to_radius = 0.055F * w * w / s + shin_room});
  }
  const Vec3 nape = body.neck_base;
  all.push_back({.joint = static_cast<std::uint8_t>(joints.chest),
                 .from = nape - Vec3{0, 0.02F, 0.0F} * s,
                 .to = nape - Vec3{0, 0.20F, -0.01F} * s,
                 .from_radius = 0.040F * s,
                 .to_radius = 0.060F * s});
  all.push_back({.joint = static_cast<std::uint8_t>(joints.neck),
                 .from = nape + Vec3{0, 0.02F, 0} * s,
                 .to = body.skull - Vec3{0, 0.05F, 0} * s,
                 .from_radius = 0.055F * s,
                 .to_radius = 0.060F * s});
  return all;
}

std::vector<ClothNode> nodes_of(const BodyShape& body, const Sheet& skirt, const Sheet& hair) {
  const float s = body.scale;
  std::vector<ClothNode> nodes;
  add_sheet(skirt, nodes);
  for (ClothNode& node : nodes) {
    // Between the legs cloth is drawn taut from the one that is further out.
    if (std::abs(node.place.x) < 0.03F * s) node.radius = 0.045F * s;
    const bool at_side = std::abs(node.outward.x) > 0.9F;
    const unsigned legs = !at_side ? 0b0101U : node.place.x > 0 ? 0b0001U : 0b0100U;
    const bool reaches_shin = node.place.y < body.limb(Side::Left).knee.y + 0.12F * s;
    node.keeps_out = static_cast<std::uint16_t>(reaches_shin ? legs | legs << 1U : legs);
  }
  const std::size_t first = nodes.size();
  add_sheet(hair, nodes);
  for (ClothNode& node : std::span(nodes).subspan(first)) node.keeps_out = 0b110000;
  return nodes;
}

}  // namespace docent::avatar
