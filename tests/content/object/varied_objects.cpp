#include "tests/content/object/varied_objects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <iterator>
#include <map>
#include <random>
#include <tuple>
#include <vector>

namespace docent::object {
namespace {

/// Places and triangles alone: what every format has.
struct Soup {
  std::vector<Vec3> place;
  std::vector<std::uint32_t> corner;
};

class Chance {
 public:
  explicit Chance(std::uint32_t seed) : engine_(seed) {}
  /// In [0, count); the same on every machine.
  std::uint32_t below(std::uint32_t count) { return static_cast<std::uint32_t>(engine_() % count); }
  bool one_in(std::uint32_t count) { return below(count) == 0; }
  float share() { return static_cast<float>(below(1 << 16)) / (1 << 16); }

 private:
  std::mt19937 engine_;
};

void append(Soup& soup, const Soup& other) {
  const auto first = static_cast<std::uint32_t>(soup.place.size());
  soup.place.insert(soup.place.end(), other.place.begin(), other.place.end());
  for (const std::uint32_t corner : other.corner) soup.corner.push_back(first + corner);
}

/// Corners at the same place are one.
Soup soup_of(const Shape& shape) {
  Soup soup;
  std::map<std::tuple<float, float, float>, std::uint32_t> known;
  for (const std::uint32_t corner : shape.indices) {
    const Vec3 p = shape.vertices[corner].position;
    const auto [it, is_new] =
        known.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(soup.place.size()));
    if (is_new) soup.place.push_back(p);
    soup.corner.push_back(it->second);
  }
  return soup;
}

float height_of(const Soup& soup) {
  const auto [low, high] = std::ranges::minmax(soup.place, {}, &Vec3::y);
  return std::max(high.y - low.y, 1e-6F);
}

/// The largest number of a place in it.
float farthest_of(const Soup& soup) {
  float farthest = 0;
  for (const Vec3& p : soup.place)
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return farthest;
}

void transform(Soup& soup, const Mat4& by) {
  for (Vec3& p : soup.place) p = Vec3(by * Vec4(p, 1));
}

void turn_inside_out(Soup& soup, Chance& chance, bool all) {
  for (std::size_t i = 0; i + 2 < soup.corner.size(); i += 3)
    if (all || chance.one_in(2)) std::swap(soup.corner[i + 1], soup.corner[i + 2]);
}

void shuffle(Soup& soup, Chance& chance) {
  for (auto n = static_cast<std::uint32_t>(soup.corner.size() / 3); n > 1; --n) {
    const std::size_t a = 3 * std::size_t{n - 1}, b = 3 * std::size_t{chance.below(n)};
    for (std::size_t i = 0; i < 3; ++i) std::swap(soup.corner[a + i], soup.corner[b + i]);
  }
}

void split(Soup& soup) {
  Soup loose;
  for (const std::uint32_t corner : soup.corner) {
    loose.corner.push_back(static_cast<std::uint32_t>(loose.place.size()));
    loose.place.push_back(soup.place[corner]);
  }
  soup = std::move(loose);
}

/// The half that lies on one side of its middle.
void cut(Soup& soup) {
  const auto [low, high] = std::ranges::minmax(soup.place, {}, &Vec3::x);
  const float middle = (low.x + high.x) / 2;
  std::vector<std::uint32_t> kept;
  for (std::size_t i = 0; i + 2 < soup.corner.size(); i += 3)
    if (soup.place[soup.corner[i]].x <= middle)
      kept.insert(kept.end(), {soup.corner[i], soup.corner[i + 1], soup.corner[i + 2]});
  if (kept.size() >= 3) soup.corner = std::move(kept);
}

/// Triangles without an area, and some twice.
void add_faults(Soup& soup, Chance& chance) {
  const auto count = static_cast<std::uint32_t>(soup.corner.size() / 3);
  for (std::uint32_t i = 0; i < 1 + count / 20; ++i) {
    const std::size_t at = 3 * std::size_t{chance.below(count)};
    const std::uint32_t a = soup.corner[at], b = soup.corner[at + 1], c = soup.corner[at + 2];
    if (chance.one_in(2))
      soup.corner.insert(soup.corner.end(), {a, b, chance.one_in(2) ? a : b});
    else
      soup.corner.insert(soup.corner.end(), {a, b, c});
  }
}

template <typename Number>
void put(std::string& out, Number value, bool big_endian = false) {
  std::array<char, sizeof(Number)> bytes;
  std::memcpy(bytes.data(), &value, sizeof value);
  if (big_endian != (std::endian::native == std::endian::big)) std::ranges::reverse(bytes);
  out.append(bytes.data(), bytes.size());
}

std::string glb(const Soup& soup, Chance& chance, std::string& told) {
  const bool is_indexed = !chance.one_in(3);
  std::string data;
  const auto put_place = [&](const Vec3& p) {
    for (const float number : {p.x, p.y, p.z}) put(data, number);
  };
  if (is_indexed)
    for (const Vec3& p : soup.place) put_place(p);
  else
    for (const std::uint32_t corner : soup.corner) put_place(soup.place[corner]);
  const std::size_t places = data.size() / 12;
  int type = 5125;
  if (places <= 65535 && chance.one_in(2)) type = 5123;
  if (places <= 255) type = 5121;
  told += is_indexed ? fmt::format(", GLB with indices of type {}", type) : ", GLB without indices";
  std::string accessors =
      fmt::format(R"({{"bufferView":0,"componentType":5126,"count":{},"type":"VEC3"}})", places);
  std::string views = fmt::format(R"({{"buffer":0,"byteLength":{}}})", data.size());
  std::string indices;
  if (is_indexed) {
    const std::size_t offset = data.size();
    for (const std::uint32_t corner : soup.corner) {
      if (type == 5121) put(data, static_cast<std::uint8_t>(corner));
      if (type == 5123) put(data, static_cast<std::uint16_t>(corner));
      if (type == 5125) put(data, corner);
    }
    accessors += fmt::format(R"(,{{"bufferView":1,"componentType":{},"count":{},"type":"SCALAR"}})",
                             type, soup.corner.size());
    views += fmt::format(R"(,{{"buffer":0,"byteOffset":{},"byteLength":{}}})", offset,
                         data.size() - offset);
    indices = R"(,"indices":1)";
  }
  std::string json = fmt::format(
      R"({{"asset":{{"version":"2.0"}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],)"
      R"("meshes":[{{"primitives":[{{"attributes":{{"POSITION":0}}{}}}]}}],"accessors":[{}],)"
      R"("bufferViews":[{}],"buffers":[{{"byteLength":{}}}]}})",
      indices, accessors, views, data.size());
  json.append((4 - json.size() % 4) % 4, ' ');
  data.append((4 - data.size() % 4) % 4, '\0');
  std::string out;
  for (const std::uint32_t word :
       {0x46546C67U, 2U, static_cast<std::uint32_t>(28 + json.size() + data.size()),
        static_cast<std::uint32_t>(json.size()), 0x4E4F534AU})
    put(out, word);
  out += json;
  put(out, static_cast<std::uint32_t>(data.size()));
  put(out, 0x004E4942U);
  return out + data;
}

std::string obj(const Soup& soup, Chance& chance, std::string& told) {
  const bool from_the_end = chance.one_in(2), has_normals = chance.one_in(2);
  told += fmt::format(", OBJ counted from the {}{}", from_the_end ? "end" : "beginning",
                      has_normals ? " with a wrong normal" : "");
  std::string out = "# a thing\r\no thing\n";
  for (const Vec3& p : soup.place)
    fmt::format_to(std::back_inserter(out), "v {} {} {}\n", p.x, p.y, p.z);
  if (has_normals) out += "vn 0 0 1\n";
  const auto count = static_cast<long>(soup.place.size());
  for (std::size_t i = 0; i + 2 < soup.corner.size(); i += 3) {
    out += 'f';
    for (std::size_t k = 0; k < 3; ++k) {
      const long corner = static_cast<long>(soup.corner[i + k]);
      fmt::format_to(std::back_inserter(out), " {}{}", from_the_end ? corner - count : corner + 1,
                     has_normals ? "//1" : "");
    }
    out += '\n';
  }
  return out;
}

std::string ply(const Soup& soup, Chance& chance, std::string& told) {
  constexpr std::array<std::string_view, 3> kinds{"ascii", "binary_little_endian",
                                                  "binary_big_endian"};
  const std::uint32_t kind = chance.below(3);
  told += fmt::format(", PLY ({})", kinds[kind]);
  std::string out = fmt::format(
      "ply\nformat {} 1.0\nelement vertex {}\nproperty float x\nproperty float y\nproperty float "
      "z\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      kinds[kind], soup.place.size(), soup.corner.size() / 3);
  const bool is_big = kind == 2;
  for (const Vec3& p : soup.place) {
    if (kind == 0)
      fmt::format_to(std::back_inserter(out), "{} {} {}\n", p.x, p.y, p.z);
    else
      for (const float number : {p.x, p.y, p.z}) put(out, number, is_big);
  }
  for (std::size_t i = 0; i + 2 < soup.corner.size(); i += 3) {
    if (kind == 0) {
      fmt::format_to(std::back_inserter(out), "3 {} {} {}\n", soup.corner[i], soup.corner[i + 1],
                     soup.corner[i + 2]);
      continue;
    }
    put(out, std::uint8_t{3});
    for (std::size_t k = 0; k < 3; ++k)
      put(out, static_cast<std::int32_t>(soup.corner[i + k]), is_big);
  }
  return out;
}

std::string stl(const Soup& soup, Chance& chance, std::string& told) {
  const bool is_text = chance.one_in(2);
  told += is_text ? ", STL (text)" : ", STL (binary)";
  std::string out = is_text ? "solid thing\n" : std::string(80, ' ');
  if (!is_text) put(out, static_cast<std::uint32_t>(soup.corner.size() / 3));
  for (std::size_t i = 0; i + 2 < soup.corner.size(); i += 3) {
    if (is_text)
      out += "facet normal 0 0 0\nouter loop\n";
    else
      for (int k = 0; k < 3; ++k) put(out, 0.0F);
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec3& p = soup.place[soup.corner[i + k]];
      if (is_text)
        fmt::format_to(std::back_inserter(out), "vertex {} {} {}\n", p.x, p.y, p.z);
      else
        for (const float number : {p.x, p.y, p.z}) put(out, number);
    }
    if (is_text)
      out += "endloop\nendfacet\n";
    else
      put(out, std::uint16_t{0});
  }
  return is_text ? out + "endsolid thing\n" : out;
}

}  // namespace

VariedObject varied(const Shape& shape, const Shape& other, std::uint32_t seed) {
  Chance chance(seed);
  Soup soup = soup_of(shape);
  VariedObject copy;
  const auto tell = [&](std::string_view what) {
    if (!copy.told.empty()) copy.told += ", ";
    copy.told += what;
  };
  if (chance.one_in(6)) {
    tell("merged with another");
    Soup second = soup_of(other);
    const float size = height_of(soup) / height_of(second);
    transform(second, glm::translate(Mat4(1), Vec3(1.5F * height_of(soup), 0, 0)) *
                          glm::scale(Mat4(1), Vec3(size)));
    append(soup, second);
  }
  const auto perhaps = [&](std::uint32_t one_in, std::string_view what, auto&& change) {
    if (!chance.one_in(one_in)) return;
    tell(what);
    change();
  };
  perhaps(6, "cut in two", [&] { cut(soup); });
  const float turn = 6.28F * chance.share();
  float unit = std::array{1.0F, 1000.0F, 100.0F, 39.37F, 0.01F}[chance.below(5)];
  // A statue in millimetres is not measured in thousandths of them: readers take a million at most.
  constexpr float most = 500'000;
  if (unit * farthest_of(soup) > most) unit = 1;
  const Vec3 stretch{0.7F + 0.6F * chance.share(), 0.7F + 0.6F * chance.share(),
                     chance.one_in(3) ? -1.0F : 1.0F};
  const bool is_lying = chance.one_in(4);
  tell(fmt::format("turned by {:.2f}, times {}{}{}", turn, unit, stretch.z < 0 ? ", mirrored" : "",
                   is_lying ? ", z up" : ""));
  Mat4 by = glm::scale(glm::rotate(Mat4(1), turn, Vec3(0, 1, 0)), unit * stretch);
  if (is_lying) by = glm::rotate(Mat4(1), 1.5707964F, Vec3(1, 0, 0)) * by;
  transform(soup, by);
  perhaps(5, "inside out", [&] { turn_inside_out(soup, chance, true); });
  perhaps(6, "half of it inside out", [&] { turn_inside_out(soup, chance, false); });
  perhaps(4, "with faults", [&] { add_faults(soup, chance); });
  perhaps(4, "shuffled", [&] { shuffle(soup, chance); });
  perhaps(4, "split", [&] { split(soup); });
  struct Format {
    std::string_view name;
    std::string (*write)(const Soup&, Chance&, std::string& told);
  };
  constexpr std::array formats{Format{"copy.glb", glb}, Format{"copy.obj", obj},
                               Format{"copy.ply", ply}, Format{"copy.stl", stl}};
  const Format& format = formats[chance.below(formats.size())];
  copy.name = format.name;
  copy.bytes = format.write(soup, chance, copy.told);
  return copy;
}

}  // namespace docent::object
