#pragma once

#include <fmt/format.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "content/content_error.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::import::gltf {

/// A part of a glTF file's JSON that knows its own name ("meshes[0].primitives[1]"), so that
/// whatever is wrong with it can be said. What is not there is an absent part; asking more of it
/// than whether it is there, or a default, is a ContentError.
class Part {
 public:
  using Json = nlohmann::json;

  Part(const std::string& file, const Json* json, std::string name)
      : file_{&file}, json_{json}, name_{std::move(name)} {}

  bool is_there() const noexcept { return json_ != nullptr; }
  const std::string& name() const noexcept { return name_; }

  [[noreturn]] void fail(const std::string& what) const {
    throw content::ContentError(*file_, 0, 0, "unreadable-model",
                                name_.empty() ? what : fmt::format("{} {}", name_, what),
                                "export the model again as glTF 2.0 or VRM");
  }

  /// A member of an object.
  Part operator[](std::string_view key) const;
  /// An entry of a list, which must be there.
  Part at(std::uint64_t index) const;
  /// How many entries a list has; 0 where it is not there.
  std::size_t size() const;

  std::uint64_t whole(std::uint64_t least, std::uint64_t most) const;
  std::uint64_t whole_or(std::uint64_t otherwise, std::uint64_t most) const {
    return is_there() ? whole(0, most) : otherwise;
  }
  /// Which of `count` things another part has; none where this is not there.
  std::int32_t index_or_none(std::size_t count, std::string_view noun) const;
  float number() const;
  float number_or(float otherwise) const { return is_there() ? number() : otherwise; }
  bool flag_or(bool otherwise) const;
  std::string text() const;
  std::string text_or(std::string_view otherwise) const {
    return is_there() ? text() : std::string(otherwise);
  }
  Vec3 vec3_or(Vec3 otherwise) const;
  Vec4 vec4_or(Vec4 otherwise) const;
  /// All members of an object, by name.
  std::vector<std::string> keys() const;

 private:
  const std::string* file_;
  const Json* json_;
  std::string name_;
};

/// Letters, digits and signs as they are; what would steer a terminal becomes a question mark.
std::string plain_name(std::string_view name);

}  // namespace docent::import::gltf
