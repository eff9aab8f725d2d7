#include "content/avatar/layers.h"

namespace docent {
namespace {

Box box_around(Vec3 a, Vec3 b, float margin) {
  return {glm::min(a, b) - margin, glm::max(a, b) + margin};
}

/// The open front between the lapels: a wedge, narrow below.
struct Neckline {
  float bottom, top, slope, front;

  explicit Neckline(const Body& body)
      : bottom{body.shoulder_height - 0.235F * body.scale},
        top{body.shoulder_height + 0.05F * body.scale},
        slope{0.27F},
        front{body.neck_base.z + 0.005F * body.scale} {}

  float half_width(float height) const { return slope * (height - bottom); }
  /// Negative between the edges of the lapels.
  float wedge(Vec3 p) const {
    return std::max(0.965F * (std::abs(p.x) - half_width(p.y)), front - p.z);
  }
};

/// The coat with its neckline and the hollow under its skirt.
float coat(const Body& body, const Neckline& neckline, Vec3 p) {
  const float s = body.scale;
  const float hollow = std::max(coat_trunk(body, p, -0.034F * s), p.y - body.hem - 0.10F * s);
  const float under_hem =
      std::max(coat_trunk(body, {p.x, std::max(p.y, body.hem + 0.05F * s), p.z}, -0.034F * s),
               p.y - body.hem - 0.10F * s);
  const float open = carve(coat_solid(body, p), std::min(hollow, under_hem), 0.008F * s);
  return carve(open, neckline.wedge(p), 0.008F * s);
}

/// A point on the coat's front, `x` from the middle.
Vec3 on_front(const Body& body, float x, float height) {
  float z = 0.35F;  // Sphere tracing from before the body.
  for (int step = 0; step < 24; ++step) z -= coat_solid(body, {x, height, z});
  return {x, height, z};
}

/// A shawl collar, rolled from the neckline's bottom round the neck, and the edge where the coat
/// closes: they lie on the coat.
struct CoatEdges {
  const Body& body;
  Neckline neckline;
  std::array<Vec3, 6> roll;  ///< Middle of the left half's roll; the right mirrors it.

  CoatEdges(const Body& of, const Neckline& open) : body{of}, neckline{open} {
    const float s = body.scale;
    const float top = body.shoulder_height;
    const auto beside = [&](float height, float out) {
      return on_front(body, neckline.half_width(height) + out * s, height);
    };
    roll = {on_front(body, 0.004F * s, neckline.bottom - 0.004F * s),
            beside(neckline.bottom + 0.09F * s, 0.020F),
            beside(top - 0.055F * s, 0.028F),
            beside(top + 0.01F * s, 0.020F),
            body.neck_base + Vec3{0.062F, 0.018F, -0.012F} * s,
            body.neck_base + Vec3{0.0F, 0.028F, -0.066F} * s};
  }

  float operator()(Vec3 p) const {
    const float s = body.scale;
    constexpr std::array<float, 6> width{0.010F, 0.030F, 0.040F, 0.034F, 0.024F, 0.024F};
    const Vec3 half{std::abs(p.x), p.y, p.z};
    float collar = 1;
    for (std::size_t k = 0; k + 1 < roll.size(); ++k)
      collar =
          join(collar, tapered_capsule(half, roll[k], roll[k + 1], width[k] * s, width[k + 1] * s),
               0.012F * s);
    const float on_coat = coat_solid(body, p);
    collar = meet(collar, on_coat - 0.012F * s, 0.012F * s);
    collar = carve(collar, neckline.wedge(p), 0.008F * s);

    const float closure_side = std::max(std::abs(p.x + 0.012F * s) - 0.028F * s, -p.z);
    float closure =
        std::max({closure_side, p.y - neckline.bottom - 0.012F * s, body.hem - 0.002F * s - p.y});
    closure = meet(closure, on_coat - 0.0045F * s, 0.005F * s);
    return std::min(collar, closure);
  }
};

/// The shirt in the neckline, with a small collar of its own.
float shirt(const Body& body, const Neckline& neckline, Vec3 p) {
  const float s = body.scale;
  const float chest = std::max(coat_trunk(body, p, -0.013F * s), p.y - neckline.top + 0.02F * s);
  const Vec3 throat = body.neck_base + Vec3{0, 0.012F, 0.004F} * s;
  const Vec3 axis = glm::normalize(Vec3{0, 1, 0.45F});
  const Vec3 off = p - throat;
  const float height = glm::dot(off, axis);
  const float ring = std::abs(glm::length(off - axis * height) - 0.0635F * s) - 0.005F * s;
  const float band = std::max(ring, std::abs(height) - 0.020F * s);
  return join(chest, band, 0.006F * s);
}

void add_head_layers(const Body& body, std::vector<Layer>& layers) {
  const float s = body.scale;
  const Box head{body.skull - Vec3{0.11F, 0.14F, 0.14F} * s,
                 body.skull + Vec3{0.11F, 0.16F, 0.14F} * s};
  const Box head_neck{{head.low.x, body.neck_base.y - 0.12F * s, head.low.z - 0.02F * s},
                      head.high};
  layers.push_back({Material::Skin, Region::Head,
                    [&body](Vec3 p) { return head_and_neck(body, p); }, head_neck, 0.0068F * s,
                    [&body, s](Vec3 p) {
                      const float collar = coat_trunk(body, p, -0.02F * s);
                      return std::min(hair(body, p), collar);
                    }});
  layers.push_back({Material::Hair, Region::Head, [&body](Vec3 p) { return hair(body, p); }, head,
                    0.013F * s,
                    [&body, s](Vec3 p) { return head_and_neck(body, p) + 0.004F * s; }});
  const Vec3 face = body.skull + Vec3{0, 0.012F, 0.075F} * s;
  layers.push_back({Material::Hair,
                    Region::Head,
                    [&body](Vec3 p) { return brows(body, p); },
                    box_around(face, face, 0.056F * s),
                    0.0045F * s,
                    {}});
  layers.push_back({Material::Eye, Region::Head, [&body](Vec3 p) { return eyes(body, p); },
                    box_around(face, face, 0.056F * s), 0.0042F * s,
                    [&body, s](Vec3 p) { return head_and_neck(body, p); }});
}

void add_coat_layers(const Body& body, std::vector<Layer>& layers) {
  const float s = body.scale;
  const Neckline neckline(body);
  const LimbPoints& left = body.limb(Side::Left);
  const float reach = std::max(left.wrist.x + 0.07F * s, 0.26F * s);
  const Box all{{-reach, body.hem - 0.02F * s, -0.28F * s},
                {reach, body.shoulder_height + 0.13F * s, 0.32F * s}};
  layers.push_back({Material::Coat,
                    Region::Coat,
                    [&body, neckline](Vec3 p) { return coat(body, neckline, p); },
                    all,
                    0.0195F * s,
                    {}});
  const Box front{{-0.19F * s, body.hem - 0.02F * s, body.neck_base.z - 0.12F * s},
                  {0.19F * s, body.shoulder_height + 0.13F * s, 0.30F * s}};
  layers.push_back({Material::Coat, Region::Coat, CoatEdges(body, neckline), front, 0.010F * s,
                    [&body, neckline](Vec3 p) { return coat(body, neckline, p); }});
  const Box chest{{-0.12F * s, neckline.bottom - 0.02F * s, neckline.front - 0.08F * s},
                  {0.12F * s, neckline.top + 0.03F * s, neckline.front + 0.20F * s}};
  layers.push_back({Material::Shirt, Region::Coat,
                    [&body, neckline, chest](Vec3 p) {
                      const Vec3 middle = 0.5F * (chest.low + chest.high);
                      const Vec3 half = 0.5F * (chest.high - chest.low) - 0.012F;
                      return std::max(shirt(body, neckline, p),
                                      rounded_box(p, middle, glm::mat3(1.0F), half, 0.01F));
                    },
                    chest, 0.0095F * s,
                    [&body, neckline](Vec3 p) { return coat(body, neckline, p); }});
}

void add_limb_layers(const Body& body, Side side, std::vector<Layer>& layers) {
  const float s = body.scale;
  const LimbPoints& limb = body.limb(side);
  const bool left = side == Side::Left;
  const Region leg = left ? Region::LeftLeg : Region::RightLeg;
  layers.push_back({Material::Skin, left ? Region::LeftHand : Region::RightHand,
                    [&body, side](Vec3 p) { return hand(body, p, side); },
                    box_around(limb.wrist - limb.hand_axis * 0.06F * s,
                               limb.wrist + limb.hand_axis * 0.18F * s, 0.075F * s),
                    0.0066F * s, [&body, side](Vec3 p) { return coat_sleeve(body, p, side); }});
  layers.push_back({Material::Trousers, leg,
                    [&body, side](Vec3 p) { return trouser_leg(body, p, side); },
                    box_around(limb.hip, limb.ankle, 0.13F * s), 0.028F * s,
                    [&body, s](Vec3 p) {
                      return body.hem + 0.14F * s - p.y;  // Above this the coat is never lifted.
                    }});
  const Vec3 sole{limb.ankle.x, 0, limb.ankle.z};
  layers.push_back({Material::Shoes, leg, [&body, side](Vec3 p) { return shoe(body, p, side); },
                    box_around(sole, limb.toe + limb.foot_forward * 0.06F * s, 0.12F * s),
                    0.014F * s, [&body, side](Vec3 p) { return trouser_leg(body, p, side); }});
}

}  // namespace

std::vector<Layer> layers_of(const Body& body) {
  std::vector<Layer> layers;
  add_coat_layers(body, layers);
  add_head_layers(body, layers);
  add_limb_layers(body, Side::Left, layers);
  add_limb_layers(body, Side::Right, layers);
  return layers;
}

}  // namespace docent
