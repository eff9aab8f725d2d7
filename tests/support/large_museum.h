#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

namespace docent::test {

/// Writes a museum as its staff would: floors that lie over one another, each of halls of 12 by 12
/// metres with doorways in all walls between them, four cases in a hall, an exhibit in each case;
/// two stairs and a lift through all floors. The same museum every time.
class LargeMuseum {
 public:
  LargeMuseum(std::filesystem::path folder, std::size_t floors, std::size_t exhibits)
      : folder_(std::move(folder)),
        floors_(floors),
        exhibits_(exhibits),
        across_(static_cast<std::size_t>(
            std::ceil(std::sqrt(static_cast<double>((exhibits + floors - 1) / floors) / 4)))) {
    std::filesystem::create_directories(folder_ / "exhibits");
    write_museum();
    for (std::size_t floor = 0; floor < floors_; ++floor) write_floor(floor);
  }

 private:
  static constexpr double hall = 12, half_wall = 0.15, half_door = 1.1;  // metres

  std::ofstream file(const std::string& name) const { return std::ofstream(folder_ / name); }

  void write_museum() const {
    std::ofstream out = file("museum.toml");
    out << "[museum]\ntitle.en = \"Large Museum\"\nlanguages = [\"en\"]\n";
    for (std::size_t i = 0; i < floors_; ++i)
      out << fmt::format(
          "[[floor]]\nname = \"f{0}\"\nshort = \"{0}\"\ntitle.en = \"Floor {0}\"\nordinal = {0}\n"
          "height = {1}\nplan = \"f{0}.geojson\"\n",
          i, 5 * i);
    out << "[kiosk]\nfloor = \"f0\"\nposition = [6, 1.2]\nfacing = 90\n";
    const double far = hall * static_cast<double>(across_);
    connect(out, "west-stairs", "stairs", 0.8, 6);
    connect(out, "east-stairs", "stairs", far - 0.8, far - 6);
    connect(out, "lift", "lift", far - 6, 0.8);
  }

  void connect(std::ofstream& out, const char* id, const char* kind, double x, double y) const {
    out << fmt::format("[[connection]]\nid = \"{}\"\nkind = \"{}\"\nstops = [\n", id, kind);
    for (std::size_t i = 0; i < floors_; ++i)
      out << fmt::format("  {{floor = \"f{}\", position = [{}, {}], facing = 180}},\n", i, x, y);
    out << "]\n";
  }

  static std::string box(double x0, double y0, double x1, double y1) {
    return fmt::format(
        "[[{0:.3f},{1:.3f}],[{2:.3f},{1:.3f}],[{2:.3f},{3:.3f}],[{0:.3f},{3:.3f}],"
        "[{0:.3f},{1:.3f}]]",
        x0, y0, x1, y1);
  }

  void write_floor(std::size_t floor) {
    std::mt19937 random(static_cast<unsigned>(floor));
    std::ofstream plan = file(fmt::format("f{}.geojson", floor));
    std::ofstream exhibits = file(fmt::format("exhibits/f{:02}.toml", floor));
    plan << "{\"type\": \"FeatureCollection\", \"features\": [\n";
    const char* comma = "";
    const auto feature = [&](const std::string& rings) {
      plan << comma
           << "{\"type\": \"Feature\", \"properties\": {}, \"geometry\": {\"type\": \"Polygon\", "
              "\"coordinates\": ["
           << rings << "]}}";
      comma = ",\n";
    };
    std::size_t left = exhibits_ / floors_ + (floor < exhibits_ % floors_ ? 1 : 0);
    for (std::size_t i = 0; i < across_ * across_; ++i) {
      const double x = hall * static_cast<double>(i % across_);
      const double y = hall * static_cast<double>(i / across_);
      std::string rings =
          box(x + half_wall, y + half_wall, x + hall - half_wall, y + hall - half_wall);
      for (int k = 0; k < 4; ++k) {
        const auto between = [&](double a, double b) {
          return a + (b - a) * static_cast<double>(random() % 1000) / 1000;
        };
        const double cx = x + 3.5 + 5 * (k % 2) + between(-0.6, 0.6);
        const double cy = y + 3.5 + 5 * (k / 2) + between(-0.6, 0.6);
        const double w = between(0.3, 0.9), d = between(0.3, 0.9);
        rings += "," + box(cx - w, cy - d, cx + w, cy + d);
        if (left == 0) continue;
        --left;
        exhibits << fmt::format(
            "[[exhibit]]\nid = \"thing-{0}-{1}-{2}\"\nfloor = \"f{0}\"\nposition = [{3:.3f}, "
            "{4:.3f}]\nfacing = {5}\ntitle.en = \"Thing {0}.{1}.{2}\"\ntext.en = \"Found under a "
            "stone.\"\n",
            floor, i, k, cx, cy, 90 * (random() % 4));
      }
      feature(rings);
      const double mx = x + hall / 2, my = y + hall / 2;
      if (i % across_ + 1 < across_)
        feature(box(x + hall - half_wall, my - half_door, x + hall + half_wall, my + half_door));
      if (i / across_ + 1 < across_)
        feature(box(mx - half_door, y + hall - half_wall, mx + half_door, y + hall + half_wall));
    }
    plan << "]}\n";
  }

  std::filesystem::path folder_;
  std::size_t floors_, exhibits_, across_;  ///< Halls in a row of a floor.
};

}  // namespace docent::test
