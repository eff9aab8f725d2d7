#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "runtime/model/motion/motion_clip.h"

namespace docent::import {

/// What a clips.toml states about a file, where it differs from what its motion shows.
struct StatedClip {
  std::optional<double> metres_per_unit{};
  std::optional<double> frame_rate{};  ///< Of AMC files, which do not say theirs.
  std::optional<ClipRole> role{};
  std::string motion_class{};  ///< Empty where nothing is stated.
};

/// A clips.toml, beside the clips:
///
///     metres_per_unit = 0.01          # for every file that does not state its own
///     frames_per_second = 120         # of AMC files
///     [clip."16_12"]                  # the file's name, with or without its extension
///     role = "turn-left"              # walk, start, stop, turn-left, turn-right, other
///     class = "walk"
///     metres_per_unit = 0.056444
struct StatedClips {
  StatedClip all;
  std::map<std::string, StatedClip> clip;  ///< By the name that the author gave.
};

/// Reads it; empty where the folder has none. Throws ContentError, with line and column, for what
/// is not TOML, unknown keys, and values out of range.
StatedClips read_clips_toml(const std::filesystem::path& folder);

/// What is stated about one file, its own entry before that for all.
StatedClip stated_for(const StatedClips& stated, const std::filesystem::path& file);

}  // namespace docent::import
