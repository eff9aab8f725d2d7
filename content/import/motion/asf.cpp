#include <fmt/core.h>

#include <map>
#include <numbers>

#include "content/import/motion/amc.h"
#include "content/import/motion/motion_text.h"
#include "content/read_source.h"

namespace docent::import {
namespace {

using DVec3 = glm::dvec3;
using DQuat = glm::dquat;

constexpr std::size_t most_bones = 1024;
constexpr std::string_view file_hint = "is this an Acclaim skeleton file (ASF)?";

DVec3 read_vector(MotionText& text, std::string_view what) {
  DVec3 v{};
  for (int i = 0; i < 3; ++i) v[i] = text.next_number(what);
  return v;
}

/// Turns about the named axes, the first of them first: "XYZ" is Rz Ry Rx.
DQuat turn_in_order(MotionText& text, std::string_view order, DVec3 radians) {
  if (order.size() != 3)
    throw text.error("bad-axis-order",
                     fmt::format("'{}' is no order of axes such as XYZ", order.substr(0, 12)));
  DQuat turn{1, 0, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t axis = std::string_view("XYZxyz").find(order[i]) % 3;
    if (std::string_view("XYZxyz").find(order[i]) == std::string_view::npos)
      throw text.error("bad-axis-order", "an axis is x, y or z");
    DVec3 about{};
    about[static_cast<int>(axis)] = 1;
    turn = glm::angleAxis(radians[static_cast<int>(i)], about) * turn;
  }
  return turn;
}

std::optional<BoneFreedom> freedom_named(std::string_view word) {
  constexpr std::array<std::string_view, 7> names{"tx", "ty", "tz", "rx", "ry", "rz", "l"};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (same_word(word, names[i])) return static_cast<BoneFreedom>(i);
  return {};
}

std::vector<BoneFreedom> read_freedoms(MotionText& text) {
  std::vector<BoneFreedom> freedoms;
  while (const auto freedom = freedom_named(text.peek_word())) {
    text.next_word();
    if (freedoms.size() == 7) throw text.error("too-many-freedoms", "a bone has seven freedoms");
    freedoms.push_back(*freedom);
  }
  return freedoms;
}

/// Reads sections (":root", ":bonedata" ...) until the text ends.
class AsfReader {
 public:
  AsfReader(std::string_view bytes, const std::string& file) : text_(bytes, file) {}

  AcclaimSkeleton read() {
    skeleton_.bone.push_back({.name = "root", .direction = {}});
    while (!text_.at_end()) {
      const std::string_view section = text_.next_word();
      if (same_word(section, ":units"))
        read_units();
      else if (same_word(section, ":root"))
        read_root();
      else if (same_word(section, ":bonedata"))
        read_bones();
      else if (same_word(section, ":hierarchy"))
        read_hierarchy();
      else if (section.starts_with(':'))
        skip_section();
      else
        throw text_.error("unexpected-word", "a section that begins with ':' was expected",
                          std::string(file_hint));
    }
    if (!has_hierarchy_)
      throw text_.error("no-hierarchy", "the skeleton has no :hierarchy", std::string(file_hint));
    return in_order_of_hierarchy();
  }

 private:
  bool in_section() { return !text_.at_end() && !text_.peek_word().starts_with(':'); }
  double angle_unit() const { return skeleton_.degrees ? std::numbers::pi / 180 : 1; }

  void skip_section() {
    text_.rest_of_line();
    while (in_section()) text_.rest_of_line();
  }

  void read_units() {
    while (in_section()) {
      if (text_.accept("length")) {
        skeleton_.length_unit = text_.next_number("the unit of length");
        if (skeleton_.length_unit <= 0)
          throw text_.error("bad-unit", "the unit of length must be more than zero");
      } else if (text_.accept("angle")) {
        skeleton_.degrees = same_word(text_.next_word(), "deg");
      } else {
        text_.next_word();
        text_.next_number("a unit");
      }
    }
  }

  void read_root() {
    std::string order = "XYZ";
    DVec3 orientation{};
    while (in_section()) {
      if (text_.accept("order")) {
        skeleton_.bone[0].freedom = read_freedoms(text_);
      } else if (text_.accept("axis")) {
        order = text_.next_word();
      } else if (text_.accept("position")) {
        read_vector(text_, "the root's position");  // AMC lines give the place in the world
      } else {
        text_.expect("orientation");
        orientation = read_vector(text_, "the root's orientation");
      }
    }
    skeleton_.bone[0].axis = turn_in_order(text_, order, orientation * angle_unit());
  }

  void read_bones() {
    while (text_.accept("begin")) {
      if (skeleton_.bone.size() == most_bones)
        throw text_.error("too-many-joints",
                          fmt::format("the skeleton has more than {} bones", most_bones));
      skeleton_.bone.push_back(read_bone());
    }
  }

  AcclaimBone read_bone() {
    AcclaimBone bone{.name = {}, .direction = {}};
    const std::size_t begin = text_.last_place();
    while (!text_.accept("end")) {
      const std::string_view field = text_.next_word();
      if (same_word(field, "name")) {
        bone.name = text_.next_word();
      } else if (same_word(field, "direction")) {
        bone.direction = read_vector(text_, "the bone's direction");
      } else if (same_word(field, "length")) {
        bone.length = text_.next_number("the bone's length");
      } else if (same_word(field, "axis")) {
        const DVec3 turns = read_vector(text_, "the bone's axis") * angle_unit();
        bone.axis = turn_in_order(text_, text_.next_word(), turns);
      } else if (same_word(field, "dof")) {
        bone.freedom = read_freedoms(text_);
      } else if (same_word(field, "limits")) {
        while (text_.peek_word().starts_with('(')) text_.rest_of_line();
      } else if (same_word(field, "id") || same_word(field, "bodymass")) {
        text_.next_number("the bone's number");
      } else if (same_word(field, "cofmass")) {
        read_vector(text_, "the centre of mass");
      } else {
        throw text_.error("unexpected-word",
                          fmt::format("'{}' is no property of a bone", field.substr(0, 24)),
                          "a bone has id, name, direction, length, axis, dof and limits");
      }
    }
    if (bone.name.empty()) throw text_.error_at(begin, "nameless-joint", "a bone has no name");
    return bone;
  }

  /// "parent child child": parents are looked up by name, children get theirs.
  void read_hierarchy() {
    has_hierarchy_ = true;
    text_.expect("begin");
    while (!text_.accept("end")) {
      const std::size_t parent = bone_named(text_.next_word());
      while (!text_.at_line_end()) {
        const std::size_t child = bone_named(text_.next_word());
        if (child == 0 || skeleton_.bone[child].parent >= 0)
          throw text_.error("two-parents",
                            fmt::format("'{}' hangs on two bones", skeleton_.bone[child].name));
        skeleton_.bone[child].parent = static_cast<int>(parent);
        children_[parent].push_back(child);
      }
    }
  }

  std::size_t bone_named(std::string_view name) {
    for (std::size_t b = 0; b < skeleton_.bone.size(); ++b)
      if (skeleton_.bone[b].name == name) return b;
    throw text_.error("unknown-bone", fmt::format("no bone is called '{}'", name.substr(0, 24)),
                      "the names in :hierarchy are those of :bonedata");
  }

  /// Bones as a walk through the tree meets them, so that parents come first. What hangs on
  /// nothing, or on itself, is left out, as the motion cannot place it.
  AcclaimSkeleton in_order_of_hierarchy() {
    AcclaimSkeleton ordered{
        .bone = {}, .length_unit = skeleton_.length_unit, .degrees = skeleton_.degrees};
    std::vector<std::pair<std::size_t, int>> waiting{{0, -1}};
    while (!waiting.empty()) {
      const auto [bone, parent] = waiting.back();
      waiting.pop_back();
      const int self = static_cast<int>(ordered.bone.size());
      ordered.bone.push_back(skeleton_.bone[bone]);
      ordered.bone.back().parent = parent;
      const std::vector<std::size_t>& children = children_[bone];
      for (auto child = children.rbegin(); child != children.rend(); ++child)
        waiting.emplace_back(*child, self);
    }
    return ordered;
  }

  MotionText text_;
  AcclaimSkeleton skeleton_;
  std::map<std::size_t, std::vector<std::size_t>> children_;
  bool has_hierarchy_ = false;
};

}  // namespace

AcclaimSkeleton parse_asf(std::string_view text, const std::string& file) {
  return AsfReader(text, file).read();
}

AcclaimSkeleton read_asf(const std::filesystem::path& path) {
  return parse_asf(content::read_recording(path), path.string());
}

}  // namespace docent::import
