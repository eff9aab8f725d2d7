#include "content/import/motion_folder.h"

#include <algorithm>

#include "content/content_error.h"
#include "content/import/motion_bvh.h"
#include "content/import/motion_text.h"

namespace docent {
namespace {

std::vector<std::filesystem::path> motion_files(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder, failure))
    if (same_word(entry.path().extension().string(), ".bvh")) files.push_back(entry.path());
  if (failure)
    throw ContentError(Errc::NotFound, folder.string(), "unreadable-folder",
                       "this folder of clips cannot be read", "check that it is there");
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::vector<FolderMotion> read_motion_folder(const std::filesystem::path& folder,
                                             std::vector<Diagnostic>& problems) {
  std::vector<FolderMotion> motions;
  std::vector<ContentError> errors;
  for (const std::filesystem::path& file : motion_files(folder)) {
    try {
      motions.push_back({.file = file.string(), .motion = read_bvh(file)});
    } catch (const ContentError& error) {
      errors.push_back(error);
    }
  }
  for (const FolderMotion& m : motions)
    problems.insert(problems.end(), m.motion.notes.begin(), m.motion.notes.end());
  if (motions.empty() && errors.empty())
    errors.emplace_back(folder.string(), 0, 0, "no-clips", "this folder holds no motion",
                        "put BVH files, or an ASF file and its AMC files, into it");
  if (errors.empty()) return motions;
  for (std::size_t i = 0; i + 1 < errors.size(); ++i) problems.push_back(to_diagnostic(errors[i]));
  throw ContentError(errors.back());
}

}  // namespace docent
