// Writes the default clips as BVH files into a folder: make_clips content/clips

#include <fmt/format.h>

#include <filesystem>

#include "content/content_error.h"
#include "content/gait/gait.h"
#include "content/gait/gait_skeleton.h"
#include "content/import/motion/bvh_write.h"

int main(int count, char** arguments) {
  if (count != 2) {
    fmt::print(stderr, "usage: make_clips FOLDER\n");
    return 2;
  }
  try {
    const docent::Skeleton skeleton = docent::gait::gait_skeleton();
    for (const docent::gait::GaitRecipe& recipe : docent::gait::default_clips()) {
      const docent::MotionClip clip = docent::gait::make_gait_clip(recipe);
      docent::import::write_bvh(skeleton, {clip.frame_rate, clip.root, clip.rotation},
                                std::filesystem::path(arguments[1]) / (recipe.name + ".bvh"));
    }
  } catch (const docent::content::ContentError& error) {
    fmt::print(stderr, "{}: {}\n", error.file, error.what());
    return 3;
  }
  return 0;
}
