#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "content/import/motion/motion_file.h"

namespace docent::import {

/// Fills `skeleton.part`: from the joints' names where they say it (CMU, Mixamo, Bandai Namco,
/// Biped and ASF names, upper or lower case, side before or behind), else from the body's shape in
/// motion: legs are the two branches that end lowest, the head's ends highest. `clip` gives the
/// poses to judge by. Parts that the skeleton does not have stay None; the hips are always joint 0.
/// Left is left of where the feet point: true where names say otherwise, which are not believed.
bool find_body_parts(Skeleton& skeleton, const MotionClip& clip);

/// What is said of a file whose names are not believed.
Diagnostic swapped_sides_note(const std::string& file);

/// Do these names mean the same part on the two sides ("LeftUpLeg" and "RightUpLeg"), or both the
/// same part of the middle ("Spine" and "Spine1")? Digits do not count.
bool are_counterparts(std::string_view name, std::string_view other);

/// For each joint, those that hang on it.
std::vector<std::vector<std::size_t>> children_of(const Skeleton& skeleton);

/// Length of the leg from hip to ankle in the skeleton's units, 0 where no leg was found.
double leg_length(const Skeleton& skeleton);

/// The unit, in metres, with which this skeleton (in file units, parts found) has an adult's size:
/// millimetres, centimetres, inches, CMU's units or metres. Throws ContentError about `file` where
/// none does.
double judge_metres_per_unit(const Skeleton& skeleton, const std::string& file);

/// Scales skeleton and motion to metres.
void scale_to_metres(RecordedMotion& motion, double metres_per_unit);

}  // namespace docent::import
