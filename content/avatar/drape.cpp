#include "content/avatar/drape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <span>
#include <type_traits>
#include <utility>

#include "content/avatar/hair.h"
#include "content/avatar/head.h"

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
constexpr float scarf_thickness = 0.010F;

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

void add_tufts(const Tufts& tufts, std::vector<ClothNode>& nodes) {
  for (std::size_t k = 0; k < tufts.size(); ++k)
    nodes.push_back({.place = tufts.place[k],
                     .outward = tufts.outward[k],
                     .stiffness = tufts.stiffness,
                     .damping = tufts.damping,
                     .drag = 0.5F});
}

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
  if (body.figure.hair != Hair::Long || body.figure.headwear == Headwear::Scarf) return {};
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

/// What hangs of a headscarf on one side of the body: chains across it.
Sheet scarf_of(const BodyShape& body, float side, std::initializer_list<float> across,
               std::initializer_list<float> height) {
  if (body.figure.headwear != Headwear::Scarf) return {};
  const float s = body.scale;
  Sheet sheet{.stiffness = 90, .tension = 40};
  sheet.top = body.skull.y - 0.215F * s;
  for (const float below : height) sheet.height.push_back(body.skull.y - below * s);
  for (const float x : across) {
    sheet.across.push_back(x * s);
    for (const float y : sheet.height) {
      const Vec3 outward = glm::normalize(Vec3{2 * x, 0, side});
      sheet.outward.push_back(outward);
      sheet.place.push_back(
          outside_of([&](Vec3 p) { return coat_trunk(body, p, scarf_thickness * s); },
                     {x * s, y, body.neck_base.z}, outward));
    }
  }
  return sheet;
}

/// A place on the head: metres on a head 22.7 cm high.
struct OnHead {
  Vec3 place, outward;
};

template <typename Solid>
Tufts tufts_at(const BodyShape& body, std::span<const OnHead> places, Solid solid) {
  Tufts tufts;
  for (const OnHead& on : places) {
    const Vec3 outward = glm::normalize(on.outward);
    tufts.outward.push_back(outward);
    tufts.place.push_back(outside_of([&](Vec3 p) { return solid(body, p); },
                                     body.skull + body.scale * on.place, outward));
  }
  return tufts;
}

Tufts beard_of(const BodyShape& body) {
  const float length = body.figure.face.beard;
  if (length <= 0) return {};
  const float s = body.scale;
  const std::array places{OnHead{{0, -0.090F - length, 0.060F}, {0, -0.4F, 1}},
                          OnHead{{0.022F, -0.100F, 0.055F}, {0.7F, -0.3F, 1}},
                          OnHead{{-0.022F, -0.100F, 0.055F}, {-0.7F, -0.3F, 1}}};
  Tufts tufts = tufts_at(body, places, beard);
  tufts.reach = 0.026F * s;
  tufts.root = 0.005F * s;
  tufts.tip = 0.028F * s;
  tufts.stiffness = 800;
  tufts.damping = 16;
  return tufts;
}

Tufts curls_of(const BodyShape& body) {
  if (body.figure.hair != Hair::Curls || !has_hair(body.figure)) return {};
  const float s = body.scale;
  constexpr Vec3 middle{0, 0.0235F, -0.012F};
  std::array<OnHead, 7> places;
  constexpr std::array<Vec3, 7> ways{{{0, 1, -0.1F},
                                      {0.35F, 0.55F, 0.9F},
                                      {-0.35F, 0.55F, 0.9F},
                                      {1, 0.15F, -0.1F},
                                      {-1, 0.15F, -0.1F},
                                      {0.5F, -0.05F, -1},
                                      {-0.5F, -0.05F, -1}}};
  for (std::size_t k = 0; k < ways.size(); ++k) places[k] = {middle, ways[k]};
  Tufts tufts = tufts_at(body, places, docent::avatar::hair);
  tufts.reach = 0.075F * s;
  tufts.root = 0.004F * s;
  tufts.tip = 0.036F * s;
  tufts.stiffness = 380;
  tufts.damping = 8;
  return tufts;
}

}  // namespace

Drapery drapery_of(const BodyShape& body) {
  Drapery drapery{.skirt = skirt_of(body),
                  .hair = long_hair_of(body),
                  .behind = scarf_of(body, -1, {-0.06F, 0, 0.06F}, {0.335F, 0.430F}),
                  .before = scarf_of(body, 1, {-0.045F, 0.045F}, {0.360F}),
                  .beard = beard_of(body),
                  .curls = curls_of(body)};
  std::size_t first = 0;
  const auto number = [&](auto&... part) { ((part.first = first, first += part.size()), ...); };
  number(drapery.skirt, drapery.hair, drapery.behind, drapery.before, drapery.beard, drapery.curls);
  return drapery;
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

float swinging_share(const Tufts& tufts, float off) {
  return tufts.size() == 0 ? 0 : smoothstep(tufts.root, tufts.tip, off);
}

void share_out(const Tufts& tufts, Vec3 p, float share, std::span<float> nodes) {
  if (tufts.size() == 0) return;
  std::vector<float> near;
  float all = 0;
  for (const Vec3& place : tufts.place) {
    const float off = glm::distance(p, place) / tufts.reach;
    all += near.emplace_back(std::exp(-off * off) + 1e-9F);
  }
  for (std::size_t k = 0; k < tufts.size(); ++k) nodes[k] += share * near[k] / all;
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
  if (body.figure.hair == Hair::Curls)
    all.push_back({.joint = static_cast<std::uint8_t>(joints.head),
                   .from = body.skull + Vec3{0, 0.03F, 0.02F} * s,
                   .to = body.skull + Vec3{0, 0.03F, -0.03F} * s,
                   .from_radius = 0.070F * s,
                   .to_radius = 0.070F * s});
  return all;
}

std::vector<ClothNode> nodes_of(const BodyShape& body, const Drapery& drapery) {
  const float s = body.scale;
  constexpr unsigned chest = 0b010000, neck = 0b100000, skull = 0b1000000;
  std::vector<ClothNode> nodes;
  add_sheet(drapery.skirt, nodes);
  for (ClothNode& node : nodes) {
    // Between the legs cloth is drawn taut from the one that is further out.
    if (std::abs(node.place.x) < 0.03F * s) node.radius = 0.045F * s;
    const bool at_side = std::abs(node.outward.x) > 0.9F;
    const unsigned legs = !at_side ? 0b0101U : node.place.x > 0 ? 0b0001U : 0b0100U;
    const bool reaches_shin = node.place.y < body.limb(Side::Left).knee.y + 0.12F * s;
    node.keeps_out = reaches_shin ? legs | legs << 1U : legs;
  }
  const auto add = [&](const auto& part, unsigned keeps_out) {
    const std::size_t first = nodes.size();
    if constexpr (std::is_same_v<decltype(part), const Sheet&>)
      add_sheet(part, nodes);
    else
      add_tufts(part, nodes);
    for (ClothNode& node : std::span(nodes).subspan(first)) node.keeps_out = keeps_out;
  };
  add(drapery.hair, chest | neck);
  add(drapery.behind, chest);
  add(drapery.before, chest);
  add(drapery.beard, chest | neck);
  add(drapery.curls, skull);
  return nodes;
}

}  // namespace docent::avatar
