#include "content/import/motion/clips_toml.h"

#include <fmt/core.h>

#include <toml++/toml.h>
#include <array>
#include <utility>

#include "content/content_error.h"
#include "content/import/motion/motion_text.h"
#include "content/read_source.h"

namespace docent::import {
namespace {

constexpr std::array<std::pair<std::string_view, ClipRole>, 6> roles{{
    {"walk", ClipRole::Walk},
    {"start", ClipRole::Start},
    {"stop", ClipRole::Stop},
    {"turn-left", ClipRole::TurnLeft},
    {"turn-right", ClipRole::TurnRight},
    {"other", ClipRole::Other},
}};

class ClipsToml {
 public:
  explicit ClipsToml(std::string file) : file_(std::move(file)) {}

  StatedClips read() const {
    const toml::table table = parse();
    StatedClips stated;
    for (const auto& [key, node] : table)
      if (key == "clip")
        read_clips(node, stated);
      else
        read_field(key.str(), node, stated.all);
    return stated;
  }

 private:
  content::ContentError error(const toml::source_region& at, std::string code,
                              const std::string& message, std::string hint = {}) const {
    return {file_, at.begin.line, at.begin.column, std::move(code), message, std::move(hint)};
  }

  toml::table parse() const {
    try {
      return toml::parse(content::read_text_source(file_), file_);
    } catch (const toml::parse_error& failure) {
      throw error(failure.source(), "not-toml", std::string(failure.description()));
    }
  }

  void read_clips(const toml::node& node, StatedClips& stated) const {
    const toml::table* clips = node.as_table();
    if (!clips)
      throw error(node.source(), "wrong-type", "'clip' should be tables such as [clip.\"walk\"]");
    for (const auto& [name, entry] : *clips) {
      const toml::table* fields = entry.as_table();
      if (!fields)
        throw error(entry.source(), "wrong-type",
                    fmt::format("'{}' should be a table", name.str()));
      StatedClip& clip = stated.clip[std::string(name.str())];
      for (const auto& [key, value] : *fields) read_field(key.str(), value, clip);
    }
  }

  void read_field(std::string_view key, const toml::node& value, StatedClip& clip) const {
    if (key == "metres_per_unit")
      clip.metres_per_unit = number(key, value, 1e-6, 1000);
    else if (key == "frames_per_second")
      clip.frame_rate = number(key, value, 1, 1000);
    else if (key == "role")
      clip.role = role(value);
    else if (key == "class")
      clip.motion_class = text(key, value);
    else
      throw error(value.source(), "unknown-key", fmt::format("'{}' is not known here", key),
                  "known are metres_per_unit, frames_per_second, role, class and [clip.\"NAME\"]");
  }

  double number(std::string_view key, const toml::node& value, double least, double most) const {
    const auto found = value.value<double>();
    if (!found || !(*found >= least && *found <= most))
      throw error(value.source(), "out-of-range",
                  fmt::format("'{}' should be a number from {} to {}", key, least, most));
    return *found;
  }

  std::string text(std::string_view key, const toml::node& value) const {
    const auto found = value.value<std::string>();
    if (!found || found->empty())
      throw error(value.source(), "wrong-type", fmt::format("'{}' should be a text", key));
    return *found;
  }

  ClipRole role(const toml::node& value) const {
    const std::string name = text("role", value);
    for (const auto& [known, role] : roles)
      if (name == known) return role;
    throw error(value.source(), "unknown-role", fmt::format("'{}' is no role", name),
                "roles are walk, start, stop, turn-left, turn-right and other");
  }

  std::string file_;
};

}  // namespace

StatedClips read_clips_toml(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "clips.toml";
  return file::is_there(file) ? ClipsToml(file.string()).read() : StatedClips{};
}

StatedClip stated_for(const StatedClips& stated, const std::filesystem::path& file) {
  StatedClip result = stated.all;
  for (const std::string& name : {file.stem().string(), file.filename().string()}) {
    const auto own = stated.clip.find(name);
    if (own == stated.clip.end()) continue;
    if (own->second.metres_per_unit) result.metres_per_unit = own->second.metres_per_unit;
    if (own->second.frame_rate) result.frame_rate = own->second.frame_rate;
    if (own->second.role) result.role = own->second.role;
    if (!own->second.motion_class.empty()) result.motion_class = own->second.motion_class;
  }
  return result;
}

}  // namespace docent::import
