#include "content/avatar/hair.h"

#include <numbers>
#include <span>

#include "content/avatar/head.h"

namespace docent::avatar {
namespace {

// All places and sizes are metres on a head 22.7 cm high, shaped for these guides.

constexpr float nowhere = 1;

/// A height for a direction round the head: radians from the front.
struct Mark {
  float around, height;
};

float at_direction(std::span<const Mark> marks, float around) {
  if (around <= marks.front().around) return marks.front().height;
  for (std::size_t k = 1; k < marks.size(); ++k)
    if (around < marks[k].around) {
      const Mark& a = marks[k - 1];
      const Mark& b = marks[k];
      return glm::mix(a.height, b.height, smoothstep(a.around, b.around, around));
    }
  return marks.back().height;
}

/// Radians from the front, 0 to pi; `z` of the axis about which it goes.
float around_head(Vec3 half) {
  return std::atan2(half.x, half.z + 0.012F);
}

/// 0 in the groove between two locks, 1 on the back of one; `c` counts locks.
float lock(float c) {
  return std::abs(std::sin(std::numbers::pi_v<float> * c));
}

/// Broad locks with finer ones on them, 0 to 1.
float locks(float c) {
  return 0.75F * lock(c) + 0.25F * lock(2 * c + 0.37F);
}

/// Radians from the back, growing to both sides.
float around_back(Vec3 half) {
  return std::atan2(half.x, -(half.z + 0.012F));
}

/// Grows out of the skin at the hairline, `line` metres below, to `full`.
float grown(float above_line, float full, float root) {
  return full * smoothstep(-0.35F * root, root, above_line);
}

constexpr std::array<Mark, 10> short_line{{{0.0F, 0.0730F},
                                           {0.45F, 0.0700F},
                                           {0.72F, 0.0560F},
                                           {0.95F, 0.0260F},
                                           {1.14F, -0.0150F},
                                           {1.32F, 0.0200F},
                                           {1.74F, 0.0260F},
                                           {2.00F, -0.0350F},
                                           {2.40F, -0.0660F},
                                           {3.14F, -0.0780F}}};

/// Down and back at the sides, straight down behind.
float combed_down(Vec3 half) {
  return (around_back(half) * 0.085F - 0.35F * half.y * smoothstep(-0.09F, 0.02F, half.z)) /
         0.0165F;
}

float short_hair(const HeadFrame& head) {
  const Vec3 p = head.p;
  const float above = 0.75F * (p.y - at_direction(short_line, around_head(head.half)));
  // Parted on the left: across the top from there.
  constexpr float part = 0.036F;
  const float from_part = p.x - part + 0.12F * (p.z - 0.03F);
  const float top = smoothstep(0.050F, 0.085F, p.y);
  const float front = smoothstep(-0.02F, 0.07F, p.z);
  const float across = (p.z * 0.80F + std::abs(from_part) * 0.55F + p.y * 0.20F) / 0.0185F;
  const float lying =
      glm::mix(locks(combed_down(head.half)), locks(across), smoothstep(0.050F, 0.072F, p.y));
  const float groove =
      glm::mix(1.0F, smoothstep(-0.004F, 0.012F, std::abs(from_part)), 0.55F * top);
  const float swept = 1 - smoothstep(0.0F, 0.05F, std::max(from_part, -0.4F * from_part));
  const float full =
      0.0080F + top * (0.009F + 0.012F * front * swept) - 0.0045F * smoothstep(0.01F, -0.07F, p.y);
  const float d = cranium(p) - grown(above, full * groove, 0.020F) -
                  0.0045F * (lying - 0.6F) * smoothstep(0.0F, 0.02F, above);
  return std::max(d, -above);
}

constexpr std::array<Mark, 8> swept_line{{{0.0F, 0.0740F},
                                          {0.50F, 0.0690F},
                                          {0.85F, 0.0420F},
                                          {1.12F, -0.0060F},
                                          {1.32F, 0.0200F},
                                          {1.78F, 0.0240F},
                                          {2.10F, -0.0420F},
                                          {3.14F, -0.0700F}}};

/// Combed to a bun that sits high on the back of the head.
float bun(const HeadFrame& head) {
  const Vec3 p = head.p;
  const Vec3 knot{0, 0.052F, -0.122F};
  const float above = 0.75F * (p.y - at_direction(swept_line, around_head(head.half)));
  // Locks run towards the knot: they are told apart by the angle round the axis to it.
  const Vec3 axis = glm::normalize(Vec3{0, 0.25F, -1});
  const Vec3 q = p - Vec3{0, 0.035F, 0};
  const Vec3 side{1, 0, 0};
  const Vec3 top = glm::cross(axis, side);
  const float turn = std::atan2(glm::dot(q, side), glm::dot(q, top));
  const float thick = grown(above, 0.0110F, 0.022F);
  float d = cranium(p) - thick -
            0.0042F * (locks(turn * 3.5F + 0.5F) - 0.6F) * smoothstep(0.0F, 0.02F, above);
  d = std::max(d, -above);
  const Vec3 k = p - knot;
  const float wound = std::atan2(k.y, k.x) * 0.64F + glm::length(Vec3{k.x, k.y, 0}) / 0.017F;
  const float ball =
      ellipsoid(p, knot, {0.0370F, 0.0355F, 0.0300F}) - 0.0038F * (locks(wound) - 0.6F);
  return join(d, ball, 0.010F);
}

constexpr std::array<Mark, 8> curly_line{{{0.0F, 0.0700F},
                                          {0.45F, 0.0670F},
                                          {0.80F, 0.0480F},
                                          {1.12F, -0.0080F},
                                          {1.40F, 0.0060F},
                                          {1.80F, 0.0000F},
                                          {2.20F, -0.0540F},
                                          {3.14F, -0.0800F}}};

/// A round head of curls: bulbs of uneven size.
float curls(const HeadFrame& head) {
  const Vec3 p = head.p;
  const float above = 0.75F * (p.y - at_direction(curly_line, around_head(head.half)));
  const Vec3 w = p / 0.0062F + 0.8F * Vec3{std::sin(p.y / 0.017F), std::sin(p.z / 0.019F),
                                           std::sin(p.x / 0.016F)};
  const float bulbs = std::sin(w.x * 0.55F) * std::sin(w.y * 0.60F) +
                      std::sin(w.y * 0.47F + 1) * std::sin(w.z * 0.52F) +
                      std::sin(w.z * 0.58F) * std::sin(w.x * 0.50F + 2);
  const float full =
      0.030F + 0.012F * smoothstep(0.0F, 0.1F, p.y) - 0.010F * smoothstep(0.0F, -0.06F, p.y);
  const float d = ellipsoid(p, {0, 0.0235F, -0.012F},
                            Vec3{0.0745F, 0.090F, 0.094F} + grown(above, full, 0.030F)) -
                  0.0044F * bulbs * smoothstep(0.0F, 0.02F, above);
  return std::max(0.75F * d, -above);
}

constexpr std::array<Mark, 7> long_line{{{0.0F, 0.0760F},
                                         {0.30F, 0.0720F},
                                         {0.70F, 0.0500F},
                                         {1.00F, 0.0080F},
                                         {1.20F, -0.0500F},
                                         {1.30F, -0.1400F},
                                         {3.14F, -0.1400F}}};

/// Parted in the middle, over the ears and behind the shoulders.
float long_hair(const HeadFrame& head) {
  const Vec3 p = head.p;
  const float above = 0.75F * (p.y - at_direction(long_line, around_head(head.half)));
  const float parting = smoothstep(-0.003F, 0.014F, std::abs(p.x));
  // Locks fall from the parting outwards and back, then down.
  const float fan = (0.75F * p.z + 0.55F * p.y) / 0.0200F;
  const float flow = (around_back(head.half) * 0.075F + 0.006F * std::sin(p.y / 0.030F)) / 0.0200F;
  const float lying = glm::mix(locks(flow), locks(fan),
                               smoothstep(-0.03F, 0.05F, p.z) * smoothstep(0.01F, 0.05F, p.y));
  const float full = (0.0150F + 0.008F * smoothstep(0.07F, 0.0F, p.y)) *
                     glm::mix(1.0F, parting, 0.5F * smoothstep(0.04F, 0.08F, p.y));
  float d = cranium(p) - grown(above, full, 0.034F) -
            0.0045F * (lying - 0.6F) * smoothstep(0.010F, 0.05F, above);
  d = std::max(d, -above);
  // Below the ears it hangs as a sheet that follows neck and back, and ends in points.
  const float drop = std::max(-p.y, 0.0F);
  const float middle = -0.040F - 0.060F * smoothstep(0.08F, 0.24F, drop);
  const float wide =
      0.0860F + 0.014F * smoothstep(0.02F, 0.14F, drop) - 0.022F * smoothstep(0.18F, 0.34F, drop);
  const float deep = 0.0620F - 0.026F * smoothstep(0.06F, 0.20F, drop);
  const float k =
      std::sqrt((p.x / wide) * (p.x / wide) + ((p.z - middle) / deep) * ((p.z - middle) / deep));
  const float turn = std::atan2(p.x, middle - p.z);
  const float wave = locks(turn * 2.6F + 0.35F * std::sin(p.y / 0.045F + 20 * p.x) + 0.5F);
  float sheet = 0.8F * ((k - 1) * 0.5F * (wide + deep) - 0.0060F * (wave - 0.6F));
  const float end = -0.265F - 0.025F * std::cos(p.x / 0.035F) + 0.012F * wave;
  sheet = meet(sheet, 0.8F * (end - p.y), 0.012F);
  sheet = meet(sheet, p.y - 0.030F, 0.020F);
  const float open = p.z - 0.018F + 0.05F * smoothstep(0.10F, 0.20F, drop);
  sheet = meet(sheet, open, 0.014F);
  return join(d, sheet, 0.020F);
}

/// Under a cap: what shows of short hair.
float cropped(const HeadFrame& head) {
  const Vec3 p = head.p;
  const float above = 0.75F * (p.y - at_direction(short_line, around_head(head.half)));
  const float d = cranium(p) - grown(above, 0.0055F, 0.012F) -
                  0.0026F * (locks(combed_down(head.half)) - 0.6F) * smoothstep(0.0F, 0.02F, above);
  return std::max({d, -above, p.y - 0.055F});
}

}  // namespace

bool has_hair(const Figure& figure) {
  return figure.hair != Hair::None && figure.headwear != Headwear::Scarf;
}

float hair(const BodyShape& body, Vec3 at) {
  const HeadFrame head(body, at);
  if (body.figure.headwear == Headwear::Cap) return cropped(head) * head.s;
  switch (body.figure.hair) {
    case Hair::Short:
      return short_hair(head) * head.s;
    case Hair::Bun:
      return bun(head) * head.s;
    case Hair::Curls:
      return curls(head) * head.s;
    case Hair::Long:
      return long_hair(head) * head.s;
    case Hair::None:
      break;
  }
  return nowhere;
}

float beard(const BodyShape& body, Vec3 at) {
  const float length = body.figure.face.beard;
  if (length <= 0) return nowhere;
  const HeadFrame head(body, at);
  const Vec3 p = head.half;
  constexpr std::array<Mark, 6> line{{{0.0F, -0.0790F},
                                      {0.30F, -0.0770F},
                                      {0.48F, -0.0560F},
                                      {0.80F, -0.0480F},
                                      {1.10F, -0.0150F},
                                      {1.28F, 0.0100F}}};
  const float around = around_head(p);
  const float under = 0.8F * (at_direction(line, around) - p.y);
  const float thick =
      grown(under, 0.0060F + 0.35F * length * smoothstep(-0.06F, -0.11F, p.y), 0.012F);
  const float skin = face(body, at) / head.s;
  float d = skin - thick;
  const float tuft =
      tapered_capsule(p, {0, -0.096F, 0.062F}, {0, -0.106F - length, 0.064F}, 0.034F, 0.014F);
  d = join(d, tuft, 0.018F);
  const float comb =
      locks((head.p.x * (1 - 1.8F * (p.y + 0.09F)) + 0.10F * (p.z - 0.05F)) / 0.0105F + 0.5F);
  d -= 0.0026F * (comb - 0.6F);
  const float back = p.z < 0.004F ? 0.004F - p.z : p.z - 1;
  d = std::max({d, -under, back, -0.16F - p.y});
  const float moustache = join(tapered_capsule(p, {0.0040F, -0.0505F, 0.0900F},
                                               {0.0180F, -0.0560F, 0.0835F}, 0.0058F, 0.0050F),
                               tapered_capsule(p, {0.0180F, -0.0560F, 0.0835F},
                                               {0.0295F, -0.0700F, 0.0720F}, 0.0050F, 0.0040F),
                               0.004F);
  const float hairs = 0.0014F * (locks((p.x + 0.6F * p.y) / 0.0075F) - 0.6F);
  return join(d, moustache - hairs, 0.004F) * head.s;
}

}  // namespace docent::avatar
