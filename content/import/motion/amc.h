#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "content/import/motion/motion_file.h"

namespace docent::import {

/// A freedom of a bone: the meaning of one number of an AMC line.
enum class BoneFreedom : std::uint8_t { Tx, Ty, Tz, Rx, Ry, Rz, Length };

/// A bone of an Acclaim skeleton. Bone 0 is the root, which has no length.
struct AcclaimBone {
  std::string name;
  int parent = -1;              ///< Comes before the bone.
  glm::dvec3 direction{};       ///< World frame of the rest pose, unit length.
  double length = 0;            ///< In file units.
  glm::dquat axis{1, 0, 0, 0};  ///< Turns the world's axes to those that the bone turns about.
  std::vector<BoneFreedom> freedom{};
};

/// An ASF file: the body that the AMC files beside it move.
struct AcclaimSkeleton {
  std::vector<AcclaimBone> bone;
  double length_unit = 1;  ///< The header's `length`: file units in an inch.
  bool degrees = true;     ///< The header's `angle`; false: radians.
};

/// Reads an Acclaim skeleton. Limits, masses and documentation are skipped. Throws ContentError,
/// with line and column.
AcclaimSkeleton read_asf(const std::filesystem::path& path);
AcclaimSkeleton parse_asf(std::string_view text, const std::string& file);

/// What an AMC file does not say.
struct AcclaimOptions {
  double frame_rate = 120;                  ///< CMU's frames a second: the format has none.
  std::optional<double> metres_per_unit{};  ///< Otherwise the ASF header's.
};

/// Reads the motion of an Acclaim skeleton. Every frame must be there and name every moving bone.
/// Throws ContentError, with line and column.
RecordedMotion read_amc(const std::filesystem::path& path, const AcclaimSkeleton& skeleton,
                        const AcclaimOptions& options = {});
RecordedMotion parse_amc(std::string_view text, const std::string& file,
                         const AcclaimSkeleton& skeleton, const AcclaimOptions& options = {});

}  // namespace docent::import
