#include "content/character/paint.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace docent::character {
namespace {

constexpr std::uint32_t samples = 2;  ///< A pixel's side.
constexpr Vec3 paper{0.90F, 0.87F, 0.80F};
constexpr float tilt = 0.14F;  ///< Radians that one looks down.

float linear_of(std::uint8_t value) {
  return std::pow(static_cast<float>(value) / 255, 2.2F);
}

std::byte shown(float linear) {
  return static_cast<std::byte>(
      std::lround(255 * std::pow(std::clamp(linear, 0.0F, 1.0F), 1 / 2.2F)));
}

/// From the world to the eye: x right, y up, z towards the eye.
Vec3 seen(Vec3 p, float yaw) {
  const float c = std::cos(yaw), s = std::sin(yaw);
  const Vec3 turned{c * p.x - s * p.z, p.y, s * p.x + c * p.z};
  const float ct = std::cos(tilt), st = std::sin(tilt);
  return {turned.x, ct * turned.y - st * turned.z, st * turned.y + ct * turned.z};
}

Vec3 lit(Vec3 colour, Vec3 normal) {
  const Vec3 sun = glm::normalize(Vec3(-0.5F, 0.8F, 0.7F));
  const float facing = std::max((glm::dot(normal, sun) + 0.3F) / 1.3F, 0.0F);
  const float sky = 0.5F + 0.5F * normal.y;
  return colour *
         (Vec3(0.24F, 0.25F, 0.28F) * (0.5F + 0.9F * sky) + Vec3(0.82F, 0.79F, 0.72F) * facing);
}

}  // namespace

Painting::Painting(std::uint32_t width, std::uint32_t height)
    : width_{width * samples},
      height_{height * samples},
      colour_(std::size_t{width_} * height_, paper),
      depth_(colour_.size(), -1e9F) {}

void Painting::fill(const Corner& a, const Corner& b, const Corner& c) {
  const auto edge = [](Vec3 from, Vec3 to, float x, float y) {
    return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
  };
  const float area = edge(a.at, b.at, c.at.x, c.at.y);
  if (std::abs(area) < 1e-6F || !std::isfinite(area)) return;
  const auto bound = [](float value, std::uint32_t most) {
    return static_cast<std::uint32_t>(std::clamp(value, 0.0F, static_cast<float>(most)));
  };
  const std::uint32_t left = bound(std::floor(std::min({a.at.x, b.at.x, c.at.x})), width_);
  const std::uint32_t right = bound(std::ceil(std::max({a.at.x, b.at.x, c.at.x})), width_);
  const std::uint32_t top = bound(std::floor(std::min({a.at.y, b.at.y, c.at.y})), height_);
  const std::uint32_t bottom = bound(std::ceil(std::max({a.at.y, b.at.y, c.at.y})), height_);
  for (std::uint32_t y = top; y < bottom; ++y)
    for (std::uint32_t x = left; x < right; ++x) {
      const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
      const float u = edge(b.at, c.at, px, py) / area, v = edge(c.at, a.at, px, py) / area;
      const float w = 1 - u - v;
      if (u < 0 || v < 0 || w < 0) continue;
      const float z = u * a.at.z + v * b.at.z + w * c.at.z;
      const std::size_t i = std::size_t{y} * width_ + x;
      if (z <= depth_[i]) continue;
      depth_[i] = z;
      colour_[i] = u * a.colour + v * b.colour + w * c.colour;
    }
}

void Painting::shade_floor(const View& view) {
  const float radius = 0.32F * view.scale * samples;
  const float x0 = view.x * samples, y0 = view.floor * samples;
  for (std::uint32_t y = 0; y < height_; ++y)
    for (std::uint32_t x = 0; x < width_; ++x) {
      const float dx = (static_cast<float>(x) - x0) / radius;
      const float dy = (static_cast<float>(y) - y0) / (radius * 0.25F);
      const float near = 1 - std::min(dx * dx + dy * dy, 1.0F);
      colour_[std::size_t{y} * width_ + x] *= 1 - 0.35F * near;
    }
}

void Painting::add(const SkinnedMesh& body, std::span<const Mat4> palette, const View& view) {
  shade_floor(view);
  std::vector<Corner> corners;
  const std::size_t first_own =
      body.vertices.size() - std::min(body.vertices.size(), body.colour.size());
  for (std::size_t i = 0; i < body.vertices.size(); ++i) {
    const SkinnedVertex& v = body.vertices[i];
    Vec3 place{0}, normal{0};
    for (std::size_t k = 0; k < 4; ++k) {
      if (v.joint[k] >= palette.size()) continue;
      const float share = static_cast<float>(v.weight[k]) / 255;
      place += share * Vec3(palette[v.joint[k]] * Vec4(v.position, 1));
      normal += share * (glm::mat3(palette[v.joint[k]]) * v.normal);
    }
    const Vec3 at = seen(place - Vec3(view.middle.x, 0, view.middle.z), view.yaw);
    Vec3 facing =
        seen(glm::length(normal) > 1e-6F ? glm::normalize(normal) : Vec3(0, 1, 0), view.yaw);
    if (facing.z < 0) facing.z = -0.5F * facing.z;  // the far side of cloth
    Vec3 colour{0.5F};
    if (i >= first_own) {
      const VertexColour& c = body.colour[i - first_own];
      colour = {linear_of(c[0]), linear_of(c[1]), linear_of(c[2])};
    }
    corners.push_back({.at = {(view.x + at.x * view.scale) * samples,
                              (view.floor - at.y * view.scale) * samples, at.z},
                       .colour = lit(colour, facing)});
  }
  for (std::size_t k = 0; k + 2 < body.indices.size(); k += 3)
    fill(corners[body.indices[k]], corners[body.indices[k + 1]], corners[body.indices[k + 2]]);
}

Pixels Painting::picture() const {
  Pixels out{.width = width_ / samples, .height = height_ / samples, .rgba = {}};
  for (std::uint32_t y = 0; y < out.height; ++y)
    for (std::uint32_t x = 0; x < out.width; ++x) {
      Vec3 sum{0};
      for (std::uint32_t s = 0; s < samples * samples; ++s)
        sum += colour_[std::size_t{y * samples + s / samples} * width_ + x * samples + s % samples];
      sum /= static_cast<float>(samples * samples);
      for (const float part : {sum.x, sum.y, sum.z}) out.rgba.push_back(shown(part));
      out.rgba.push_back(std::byte{255});
    }
  return out;
}

}  // namespace docent::character
