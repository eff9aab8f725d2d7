#include "tests/content/motion/shipped_clips.h"

#include <stdexcept>

#include "content/import/motion/motion_folder.h"
#include "tests/support/reference_data.h"

namespace docent::test {

const MotionClip& ShippedClips::named(const std::string& name) const {
  for (const motion::offline::SourceClip& source : clips)
    if (source.clip.name == name) return source.clip;
  throw std::runtime_error("no clip is called " + name);
}

const ShippedClips& shipped_clips() {
  static const ShippedClips shipped = [] {
    ShippedClips result;
    std::vector<Diagnostic> problems;
    for (const import::FolderMotion& m :
         import::read_motion_folder(source_dir() / "content/clips", problems)) {
      result.skeleton = m.motion.skeleton;
      result.clips.push_back({.clip = m.motion.clip, .file = m.file});
    }
    return result;
  }();
  return shipped;
}

const MotionGraph& shipped_graph() {
  static const MotionGraph graph = [] {
    std::vector<Diagnostic> warnings;
    return motion::offline::make_motion_graph(shipped_clips().skeleton, shipped_clips().clips,
                                              "clips", {}, warnings);
  }();
  return graph;
}

}  // namespace docent::test
