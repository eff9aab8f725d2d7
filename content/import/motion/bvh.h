#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "content/import/motion/motion_file.h"

namespace docent::import {

/// Reads a Biovision hierarchy file: any order of channels, any joint names, positions on any joint
/// (they take the place of its OFFSET), blanks and line ends of every kind, comments.
///
/// A dummy root above the hips is folded into them, and a T-pose put before the recording is
/// dropped, with a note. `metres_per_unit` states the unit; without it the body's height decides.
/// Throws ContentError, with line and column, where the file is cut short or not a BVH.
RecordedMotion read_bvh(const std::filesystem::path& path,
                        std::optional<double> metres_per_unit = {});

/// The same from a text in memory; `file` is the name that errors give.
RecordedMotion parse_bvh(std::string_view text, const std::string& file,
                         std::optional<double> metres_per_unit = {});

}  // namespace docent::import
