#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "content/import/motion/motion_file.h"

namespace docent::import {

/// A recording of a folder, with what clips.toml states about it.
struct FolderMotion {
  std::string file;
  RecordedMotion motion;
  std::optional<ClipRole> role{};
  std::string motion_class{};  ///< Empty where nothing is stated.
};

/// Reads every BVH and AMC file of a folder, in the order of their names. Subfolders are not
/// searched.
///
/// Broken files are reported in `problems`, all but the last, which is thrown (ContentError) after
/// everything was read; so is a folder that is missing or holds no motion. Notes of the importers
/// go to `problems` as warnings.
std::vector<FolderMotion> read_motion_folder(const std::filesystem::path& folder,
                                             std::vector<Diagnostic>& problems);

}  // namespace docent::import
