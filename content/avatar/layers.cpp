#include "content/avatar/layers.h"

#include "content/avatar/hair.h"
#include "content/avatar/head.h"
#include "content/avatar/headwear.h"
#include "content/avatar/simplify.h"

// Measures with `s` are metres on a person of 1.70 m, shaped for this avatar; `s` scales them.

namespace docent::avatar {
namespace {

Box3 box_around(Vec3 a, Vec3 b, float margin) {
  return {glm::min(a, b) - margin, glm::max(a, b) + margin};
}

/// The open front between the lapels: a wedge, narrow below.
struct Neckline {
  float bottom, top, slope, front;

  explicit Neckline(const BodyShape& body)
      : bottom{body.shoulder_height - body.cut.neckline * body.scale},
        top{body.shoulder_height + 0.05F * body.scale},
        slope{0.065F / (body.cut.neckline + 0.05F)},
        front{body.neck_base.z + 0.005F * body.scale} {}

  float half_width(float height) const { return slope * (height - bottom); }
  /// Negative between the edges of the lapels.
  float wedge(Vec3 p) const {
    return std::max(0.965F * (std::abs(p.x) - half_width(p.y)), front - p.z);
  }
};

/// The coat with its neckline and the hollow under its skirt.
float coat(const BodyShape& body, const Neckline& neckline, Vec3 p) {
  const float s = body.scale;
  const float hollow = std::max(coat_trunk(body, p, -0.034F * s), p.y - body.hem - 0.10F * s);
  const float under_hem =
      std::max(coat_trunk(body, {p.x, std::max(p.y, body.hem + 0.05F * s), p.z}, -0.034F * s),
               p.y - body.hem - 0.10F * s);
  const float open = carve(coat_solid(body, p), std::min(hollow, under_hem), 0.008F * s);
  return carve(open, neckline.wedge(p), 0.008F * s);
}

/// A point on the coat's front, `x` from the middle.
Vec3 on_front(const BodyShape& body, float x, float height) {
  float z = 0.35F;  // Metres: sphere tracing from before the body.
  for (int step = 0; step < 24; ++step) z -= coat_solid(body, {x, height, z});
  return {x, height, z};
}

/// Lapels and collar, and the edge where the coat closes: they lie on the coat.
struct CoatEdges {
  const BodyShape& body;
  Neckline neckline;

  CoatEdges(const BodyShape& of, const Neckline& open) : body{of}, neckline{open} {}

  /// A lapel grows from the neckline's bottom to the collar.
  float lapel(Vec3 p, float on_coat) const {
    const float s = body.scale;
    const float height = body.shoulder_height - neckline.bottom;
    const float t = std::clamp((p.y - neckline.bottom) / height, 0.0F, 1.2F);
    const float width = (0.004F + 0.098F * t - 0.052F * t * t) * s;
    const float outer = 0.9F * (std::abs(p.x) - neckline.half_width(p.y) - width);
    const float ends = std::max({neckline.bottom - 0.006F * s - p.y, neckline.front - p.z,
                                 p.y - body.shoulder_height - 0.02F * s});
    return meet(std::max(outer, ends), on_coat - 0.009F * s, 0.006F * s);
  }

  /// A band that stands round the neck, higher behind, on an ellipse as wide as the neckline.
  float collar(Vec3 p) const {
    const float s = body.scale;
    constexpr float half_width = 0.069F, half_depth = 0.066F;
    const Vec3 q = (p - body.neck_base) / s - Vec3{0, 0.012F, -0.004F};
    const float round =
        std::sqrt(q.x * q.x / (half_width * half_width) + q.z * q.z / (half_depth * half_depth));
    const float out = (round - 1) * 0.5F * (half_width + half_depth) + 0.25F * (q.y + 0.02F);
    const float up = q.y + 0.38F * q.z + 0.9F * std::max(q.z - 0.02F, 0.0F);
    const float across = std::max(std::abs(out) - 0.003F, 0.0F);
    const float along = std::max(std::abs(up) - 0.022F, 0.0F);
    return (std::sqrt(across * across + along * along) - 0.0065F) * s;
  }

  /// The edge of the panel that closes over the other; towards the right it sinks into the coat.
  float closure(Vec3 p, float on_coat) const {
    const float s = body.scale;
    const float strip = std::max(std::abs(p.x + 0.015F * s) - 0.045F * s, -p.z);
    const float ends = std::max(p.y - neckline.bottom - 0.012F * s, body.hem - 0.002F * s - p.y);
    const float raised = 0.0055F * s + 0.11F * (p.x - 0.03F * s);
    return meet(std::max(strip, ends), on_coat - raised, 0.003F * s);
  }

  /// Pockets' flaps, a uniform's belt and shoulder straps, a dress's sash.
  float details(Vec3 p, float on_coat) const {
    const float s = body.scale;
    float d = 1;
    const auto patch = [&](float x, float y, float half_x, float half_y, float raised) {
      const float flat =
          std::max(std::abs(std::abs(p.x) - x * s) - half_x * s, std::abs(p.y - y) - half_y * s);
      d = std::min(d, meet(std::max(flat, -p.z), on_coat - raised * s, 0.003F * s));
    };
    const float waist = body.hip_height + 0.40F * (body.shoulder_height - body.hip_height);
    const auto belt = [&](float half) {
      d = std::min(d, meet(std::abs(p.y - waist) - half * s, coat_trunk(body, p, 0) - 0.006F * s,
                           0.004F * s));
    };
    if (body.cut.pockets) patch(0.105F, body.hip_height + 0.035F * s, 0.052F, 0.020F, 0.006F);
    if (body.figure.garment == Garment::Uniform) {
      patch(0.085F, body.shoulder_height - 0.115F * s, 0.036F, 0.016F, 0.006F);
      belt(0.020F);
    }
    if (body.figure.garment == Garment::Dress) belt(0.024F);
    return d;
  }

  float operator()(Vec3 p) const {
    const float s = body.scale;
    const float on_coat = coat_solid(body, p);
    if (!body.cut.lapels)
      return std::min(carve(collar(p), neckline.wedge(p), 0.006F * s), details(p, on_coat));
    const float edges =
        std::min(join(lapel(p, on_coat), collar(p), 0.01F * s), details(p, on_coat));
    return std::min(carve(edges, neckline.wedge(p), 0.006F * s), closure(p, on_coat));
  }
};

/// A row of buttons down the closing edge.
struct Buttons {
  std::array<Vec3, 4> place;
  Vec3 radius;

  Buttons(const BodyShape& body, const Neckline& neckline)
      : radius{Vec3{0.0115F, 0.0115F, 0.0065F} * body.scale} {
    float height = neckline.bottom - 0.030F * body.scale;
    for (Vec3& button : place) {
      button = on_front(body, 0.006F * body.scale, height) + Vec3{0, 0, 0.002F} * body.scale;
      height -= 0.112F * body.scale;
    }
  }

  float operator()(Vec3 p) const {
    float nearest = 1;
    for (const Vec3& button : place) nearest = std::min(nearest, ellipsoid(p, button, radius));
    return nearest;
  }
};

/// The shirt in the neckline, with a small collar of its own.
float shirt(const BodyShape& body, const Neckline& neckline, Vec3 p) {
  const float s = body.scale;
  const float chest = std::max(coat_trunk(body, p, -0.013F * s), p.y - neckline.top + 0.02F * s);
  // A band round the neck, lower in front.
  const Vec3 axis = glm::normalize(Vec3{0, 1, 0.45F});
  const float height = half_space(p, body.neck_base + Vec3{0, 0.004F, 0.004F} * s, axis);
  const float band =
      meet(head_and_neck(body, p) - 0.006F * s, std::abs(height) - 0.024F * s, 0.006F * s);
  return join(chest, band, 0.006F * s);
}

void add_head_layers(const BodyShape& body, std::vector<Layer>& layers) {
  const float s = body.scale;
  const Box3 head{body.skull - Vec3{0.11F, 0.14F, 0.14F} * s,
                  body.skull + Vec3{0.11F, 0.16F, 0.14F} * s};
  const Box3 head_neck{{head.low.x, body.neck_base.y - 0.12F * s, head.low.z - 0.02F * s},
                       head.high};
  const Box3 hair_box{
      body.skull - Vec3{0.14F, body.figure.hair == Hair::Long ? 0.33F : 0.13F, 0.17F} * s,
      head.high + Vec3{0.03F, 0.02F, 0.03F} * s};
  const Vec3 eye_line = body.skull + Vec3{0, 0.012F, 0.075F} * s;
  const Box3 face = box_around(eye_line, eye_line, 0.056F * s);
  layers.push_back({.material = Material::Skin,
                    .region = BodyRegion::Head,
                    .solid = [&body](Vec3 p) { return head_and_neck(body, p); },
                    .box = head_neck,
                    .cell = 0.0017F * s,
                    .error = 0.0016F * s,
                    .triangles = 3000,
                    .lens = [&body](Vec3 p) { return magnified_face(body, p); },
                    .covered =
                        [&body, s](Vec3 p) {
                          return std::min({hair(body, p), headwear(body, p), beard(body, p),
                                           coat_trunk(body, p, -0.02F * s)});
                        }});
  if (has_hair(body.figure))
    layers.push_back({.material = Material::Hair,
                      .region = BodyRegion::Hair,
                      .solid = [&body](Vec3 p) { return hair(body, p); },
                      .box = hair_box,
                      .cell = 0.0026F * s,
                      .error = 0.0026F * s,
                      .triangles = 2000,
                      .covered = [&body](Vec3 p) { return head_and_neck(body, p); }});
  const bool scarf = body.figure.headwear == Headwear::Scarf;
  if (body.figure.headwear != Headwear::None)
    layers.push_back(
        {.material = body.figure.headwear == Headwear::Cap ? Material::Coat : Material::Second,
         .region = scarf ? BodyRegion::Scarf : BodyRegion::Head,
         .solid = [&body](Vec3 p) { return headwear(body, p); },
         .box = {body.skull + Vec3{-0.19F, scarf ? -0.50F : -0.30F, -0.21F} * s,
                 body.skull + Vec3{0.19F, 0.16F, 0.22F} * s},
         .cell = 0.0040F * s,
         .error = 0.0031F * s,
         .triangles = scarf ? 2000U : 1200U,
         .covered = [&body](Vec3 p) { return head_and_neck(body, p); }});
  if (body.figure.face.beard > 0)
    layers.push_back({.material = Material::Hair,
                      .region = BodyRegion::Beard,
                      .solid = [&body](Vec3 p) { return beard(body, p); },
                      .box = {body.skull + Vec3{-0.09F, -0.19F, -0.01F} * s,
                              body.skull + Vec3{0.09F, 0.02F, 0.13F} * s},
                      .cell = 0.0028F * s,
                      .error = 0.0026F * s,
                      .triangles = 2000,
                      .covered = [&body](Vec3 p) { return head_and_neck(body, p); }});
  const auto of_face = [&](Material material, auto solid, Box3 box, float cell,
                           std::size_t triangles) {
    layers.push_back({.material = material,
                      .region = BodyRegion::Head,
                      .solid = [&body, solid](Vec3 p) { return solid(body, p); },
                      .box = box,
                      .cell = cell * s,
                      .error = 0.0015F * s,
                      .triangles = triangles,
                      .covered = [&body](Vec3 p) { return head_and_neck(body, p); }});
  };
  of_face(Material::Hair, brows, face, 0.0014F, 160);
  of_face(Material::White, eye_whites, face, 0.0018F, 160);
  of_face(Material::Eye, irises, face, 0.0009F, 120);
  of_face(Material::Lips, lips,
          box_around(body.skull + Vec3{-0.027F, -0.074F, 0.08F} * s,
                     body.skull + Vec3{0.027F, -0.054F, 0.08F} * s, 0.014F * s),
          0.0011F, 260);
}

void add_coat_layers(const BodyShape& body, std::vector<Layer>& layers) {
  const float s = body.scale;
  const Neckline neckline(body);
  const DistanceField whole = [&body, neckline](Vec3 p) { return coat(body, neckline, p); };
  const float reach = std::max(body.limb(Side::Left).wrist.x + 0.07F * s, 0.26F * s);
  const float top = body.shoulder_height + 0.13F * s;
  const float hem = body.hem - 0.02F * s;
  layers.push_back({.material = Material::Coat,
                    .region = BodyRegion::Coat,
                    .solid = whole,
                    .box = {{-reach, hem, -0.28F * s}, {reach, top, 0.32F * s}},
                    .cell = 0.0085F * s,
                    .error = 0.0042F * s,
                    .triangles = 2700,
                    .lens = wavy(0.06F * s, 0.0012F * s),
                    .covered = {}});
  layers.push_back(
      {.material = Material::Coat,
       .region = BodyRegion::Coat,
       .solid = CoatEdges(body, neckline),
       .box = {{-0.19F * s, hem, body.neck_base.z - 0.12F * s}, {0.19F * s, top, 0.30F * s}},
       .cell = 0.0058F * s,
       .error = 0.0031F * s,
       .triangles = 1100,
       .covered = whole});
  const Buttons buttons(body, neckline);
  if (body.cut.buttons)
    layers.push_back({.material = Material::Trousers,
                      .region = BodyRegion::Coat,
                      .solid = buttons,
                      .box = box_around(buttons.place.front(), buttons.place.back(), 0.02F * s),
                      .cell = 0.0042F * s,
                      .error = 0.0013F * s,
                      .triangles = 240,
                      .covered = whole});
  const Box3 chest{{-0.12F * s, neckline.bottom - 0.02F * s, neckline.front - 0.08F * s},
                   {0.12F * s, neckline.top + 0.04F * s, neckline.front + 0.20F * s}};
  layers.push_back({.material = Material::Shirt,
                    .region = BodyRegion::Coat,
                    .solid =
                        [&body, neckline, chest](Vec3 p) {
                          const Vec3 middle = 0.5F * (chest.low + chest.high);
                          const Vec3 half = 0.5F * (chest.high - chest.low) - 0.012F;
                          return std::max(shirt(body, neckline, p),
                                          rounded_box(p, middle, glm::mat3(1.0F), half, 0.01F));
                        },
                    .box = chest,
                    .cell = 0.0085F * s,
                    .error = 0.0018F * s,
                    .covered = whole});
}

void add_limb_layers(const BodyShape& body, Side side, std::vector<Layer>& layers) {
  const float s = body.scale;
  const LimbPoints& limb = body.limb(side);
  const bool left = side == Side::Left;
  // A robe reaches so far down that the shins stay inside it.
  const float lifted = body.cut.hem < -0.2F ? 0.01F : 0.14F;
  const BodyRegion leg = left ? BodyRegion::LeftLeg : BodyRegion::RightLeg;
  layers.push_back({.material = Material::Skin,
                    .region = left ? BodyRegion::LeftHand : BodyRegion::RightHand,
                    .solid = [&body, side](Vec3 p) { return hand(body, p, side); },
                    .box = box_around(limb.wrist - limb.hand_axis * 0.06F * s,
                                      limb.wrist + limb.hand_axis * 0.18F * s, 0.075F * s),
                    .cell = 0.0034F * s,
                    .error = 0.0026F * s,
                    .triangles = 700,
                    .covered = [&body, side](Vec3 p) { return coat_sleeve(body, p, side); }});
  layers.push_back({.material = body.cut.bare_legs ? Material::Skin : Material::Trousers,
                    .region = leg,
                    .solid = [&body, side](Vec3 p) { return trouser_leg(body, p, side); },
                    .box = box_around(limb.hip, limb.ankle, 0.13F * s),
                    .cell = 0.0075F * s,
                    .error = 0.0042F * s,
                    .triangles = 560,
                    .lens = wavy(0.05F * s, 0.0012F * s),
                    // Above this the coat is never lifted.
                    .covered = [&body, s, lifted](Vec3 p) { return body.hem + lifted * s - p.y; }});
  layers.push_back({.material = Material::Shoes,
                    .region = leg,
                    .solid = [&body, side](Vec3 p) { return shoe(body, p, side); },
                    .box = box_around({limb.ankle.x, 0, limb.ankle.z},
                                      limb.toe + limb.foot_forward * 0.06F * s, 0.12F * s),
                    .cell = 0.0050F * s,
                    .error = 0.0031F * s,
                    .triangles = 420,
                    .covered = [&body, side](Vec3 p) { return trouser_leg(body, p, side); }});
}

}  // namespace

std::vector<Layer> layers_of(const BodyShape& body) {
  std::vector<Layer> layers;
  add_coat_layers(body, layers);
  add_head_layers(body, layers);
  add_limb_layers(body, Side::Left, layers);
  add_limb_layers(body, Side::Right, layers);
  return layers;
}

}  // namespace docent::avatar
