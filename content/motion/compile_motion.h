#pragma once

#include <filesystem>
#include <span>

#include "content/motion/make_motion_graph.h"

namespace docent::motion::offline {

/// Makes a motion graph of the recordings in folders (BVH, ASF/AMC; a clips.toml may state units
/// and roles). Folders are taken in their order, files in the order of their names.
///
/// Every broken file is reported: `problems` gets the warnings and all errors but the last, which
/// is thrown as ContentError. A folder without motion is an error. Clips of another skeleton than
/// most are left out with a warning; clips of a lower frame rate are brought to the highest.
MotionGraph compile_motion(std::span<const std::filesystem::path> folders,
                           const MotionOptions& options, std::vector<Diagnostic>& problems);
MotionGraph compile_motion(const std::filesystem::path& folder, const MotionOptions& options,
                           std::vector<Diagnostic>& problems);

}  // namespace docent::motion::offline
