#include "content/import/gltf/springs.h"

#include <fmt/format.h>

#include <algorithm>

#include "content/content_error.h"

namespace docent::import::gltf {
namespace {

constexpr std::size_t most_colliders_of_one = 256;

/// What is left out, and why: the first few are told one by one.
class LeftOut {
 public:
  LeftOut(Source& source, const char* noun) : source_{source}, noun_{noun} {}
  ~LeftOut() {
    if (count_ > most_told)
      source_.warn(
          fmt::format("{} more {}s cannot be used and are left out", count_ - most_told, noun_));
  }
  LeftOut(const LeftOut&) = delete;
  LeftOut& operator=(const LeftOut&) = delete;

  /// Reads one; what it lacks is told.
  template <typename Read>
  void reading(Read read) {
    try {
      read();
    } catch (const content::ContentError& error) {
      if (++count_ <= most_told)
        source_.warn(fmt::format("a {} is left out: {}", noun_, error.what()));
    }
  }

 private:
  static constexpr std::size_t most_told = 3;

  Source& source_;
  const char* noun_;
  std::size_t count_ = 0;
};

/// How many of a list are read.
std::size_t as_many(Source& source, const Part& list, const char* noun) {
  const std::size_t size = list.size();
  if (size <= most_springs) return size;
  source.warn(fmt::format("it has {} {}s, and the first {} are taken", size, noun, most_springs));
  return most_springs;
}

float not_negative(const Part& part, float otherwise) {
  const float value = part.number_or(otherwise);
  if (value < 0) part.fail("must not be negative");
  return value;
}

std::int32_t node_of(const Part& part, std::size_t nodes) {
  if (!part.is_there()) part.fail("is missing");
  return part.index_or_none(nodes, "node");
}

/// VRM 0.x writes places as objects.
Vec3 xyz_or(const Part& part, Vec3 otherwise) {
  if (!part.is_there()) return otherwise;
  return {part["x"].number_or(0), part["y"].number_or(0), part["z"].number_or(0)};
}

/// Which of the colliders that are read each of a file's groups has.
using Groups = std::vector<std::vector<std::uint32_t>>;

void add_groups(const Part& list, const Groups& groups, Spring& spring) {
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::int32_t group = list.at(i).index_or_none(groups.size(), "collider group");
    const std::vector<std::uint32_t>& more = groups[entry(group)];
    if (spring.colliders.size() + more.size() > most_colliders_of_one)
      list.fail("names too many colliders");
    spring.colliders.insert(spring.colliders.end(), more.begin(), more.end());
  }
  std::ranges::sort(spring.colliders);
  const auto again = std::ranges::unique(spring.colliders);
  spring.colliders.erase(again.begin(), again.end());
}

SpringCollider collider_1_0(const Part& part, std::size_t nodes) {
  SpringCollider collider{.node = node_of(part["node"], nodes)};
  const Part sphere = part["shape"]["sphere"], capsule = part["shape"]["capsule"];
  const Part& shape = capsule.is_there() ? capsule : sphere;
  if (!shape.is_there()) part.fail("is neither a sphere nor a capsule");
  collider.from = collider.to = shape["offset"].vec3_or(Vec3{0});
  if (capsule.is_there()) collider.to = capsule["tail"].vec3_or(Vec3{0});
  collider.radius = not_negative(shape["radius"], 0);
  return collider;
}

SpringJoint joint_1_0(const Part& part, std::size_t nodes) {
  SpringJoint joint{.node = node_of(part["node"], nodes)};
  joint.stiffness = not_negative(part["stiffness"], 1);
  const float power = part["gravityPower"].number_or(0);
  joint.gravity = power * part["gravityDir"].vec3_or(Vec3{0, -1, 0});
  joint.drag = std::min(not_negative(part["dragForce"], 0.5F), 1.0F);
  joint.hit_radius = not_negative(part["hitRadius"], 0);
  return joint;
}

}  // namespace

void read_springs_1_0(Source& source, const Part& part, std::size_t nodes, Vrm& vrm) {
  if (!part.is_there()) return;
  std::vector<std::int32_t> kept;  // of the file's colliders, where they are in `vrm`
  LeftOut collider_left(source, "collider"), group_left(source, "collider group"),
      spring_left(source, "spring");
  collider_left.reading([&] {
    const Part list = part["colliders"];
    for (std::size_t i = 0, count = as_many(source, list, "collider"); i < count; ++i) {
      kept.push_back(none);
      collider_left.reading([&] {
        vrm.colliders.push_back(collider_1_0(list.at(i), nodes));
        kept.back() = static_cast<std::int32_t>(vrm.colliders.size()) - 1;
      });
    }
  });
  Groups groups;
  group_left.reading([&] {
    const Part list = part["colliderGroups"];
    for (std::size_t i = 0, count = as_many(source, list, "collider group"); i < count; ++i) {
      groups.emplace_back();
      group_left.reading([&] {
        const Part members = list.at(i)["colliders"];
        if (members.size() > most_springs) members.fail("names too many colliders");
        for (std::size_t k = 0; k < members.size(); ++k)
          if (const std::int32_t one =
                  kept[entry(members.at(k).index_or_none(kept.size(), "collider"))];
              one != none)
            groups.back().push_back(static_cast<std::uint32_t>(one));
      });
    }
  });
  spring_left.reading([&] {
    const Part list = part["springs"];
    vrm.spring_count = list.size();
    std::size_t joints_read = 0;
    for (std::size_t i = 0, count = as_many(source, list, "spring"); i < count; ++i)
      spring_left.reading([&] {
        Spring spring{.part = list.at(i).name(), .joints = {}, .colliders = {}};
        const Part joints = list.at(i)["joints"];
        joints_read += joints.size();
        if (joints_read > most_nodes) joints.fail("has more joints than any body");
        for (std::size_t k = 0; k < joints.size(); ++k)
          spring.joints.push_back(joint_1_0(joints.at(k), nodes));
        add_groups(list.at(i)["colliderGroups"], groups, spring);
        vrm.springs.push_back(std::move(spring));
      });
  });
}

void read_springs_0(Source& source, const Part& part, std::size_t nodes, Vrm& vrm) {
  if (!part.is_there()) return;
  Groups groups;
  LeftOut collider_left(source, "collider"), spring_left(source, "spring");
  collider_left.reading([&] {
    const Part list = part["colliderGroups"];
    for (std::size_t i = 0, count = as_many(source, list, "collider group"); i < count; ++i) {
      groups.emplace_back();
      collider_left.reading([&] {
        const std::int32_t node = node_of(list.at(i)["node"], nodes);
        const Part balls = list.at(i)["colliders"];
        for (std::size_t k = 0; k < balls.size(); ++k) {
          if (vrm.colliders.size() >= most_springs) balls.fail("are more than any body has");
          // "offset" has its z the other way (UniVRM writes it as Unity has it).
          const Vec3 offset = xyz_or(balls.at(k)["offset"], Vec3{0}) * Vec3{1, 1, -1};
          const float radius = not_negative(balls.at(k)["radius"], 0);
          groups.back().push_back(static_cast<std::uint32_t>(vrm.colliders.size()));
          vrm.colliders.push_back({.node = node, .from = offset, .to = offset, .radius = radius});
        }
      });
    }
  });
  spring_left.reading([&] {
    const Part list = part["boneGroups"];
    for (std::size_t i = 0, count = as_many(source, list, "spring"); i < count; ++i)
      spring_left.reading([&] {
        const Part group = list.at(i), bones = group["bones"];
        vrm.spring_count += bones.size();
        SpringJoint joint;
        // The format itself spells it so.
        joint.stiffness = not_negative(group["stiffiness"], 1);
        joint.gravity =
            group["gravityPower"].number_or(0) * xyz_or(group["gravityDir"], {0, -1, 0});
        joint.drag = std::min(not_negative(group["dragForce"], 0.4F), 1.0F);
        joint.hit_radius = not_negative(group["hitRadius"], 0.02F);
        Spring spring{.part = group.name(), .joints = {}, .takes_all_below = true, .colliders = {}};
        add_groups(group["colliderGroups"], groups, spring);
        for (std::size_t b = 0; b < bones.size(); ++b)
          spring_left.reading([&] {
            if (vrm.springs.size() >= most_springs) bones.fail("are more than any body has");
            joint.node = node_of(bones.at(b), nodes);
            spring.joints = {joint};
            vrm.springs.push_back(spring);
          });
      });
  });
}

}  // namespace docent::import::gltf
