#include "content/import/motion/motion_folder.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "content/content_error.h"
#include "content/import/motion/amc.h"
#include "content/import/motion/bvh.h"
#include "content/import/motion/clips_toml.h"
#include "content/import/motion/motion_text.h"

namespace docent::import {
namespace {

bool has_extension(const std::filesystem::path& file, std::string_view extension) {
  return same_word(file.extension().string(), extension);
}

std::vector<std::filesystem::path> files_of(const std::filesystem::path& folder) {
  std::error_code failure;
  std::vector<std::filesystem::path> files;
  for (std::filesystem::directory_iterator entry(folder, failure);
       !failure && entry != std::filesystem::directory_iterator(); entry.increment(failure)) {
    std::error_code gone;
    if (entry->is_regular_file(gone)) files.push_back(entry->path());
  }
  if (failure)
    throw content::ContentError(Errc::NotFound, folder.string(), "unreadable-folder",
                                "this folder of clips cannot be read",
                                "check that it is there and that its permissions let you read it");
  std::ranges::sort(files);
  return files;
}

/// Reads the files of one folder and keeps what goes wrong.
class FolderReader {
 public:
  FolderReader(const std::filesystem::path& folder, std::vector<Diagnostic>& problems)
      : folder_(folder), problems_(problems), files_(files_of(folder)) {}

  std::vector<FolderMotion> read() {
    attempt([&] { stated_ = read_clips_toml(folder_); });
    warn_of_unknown_clips();
    for (const auto& file : files_)
      if (has_extension(file, ".bvh"))
        attempt([&] { add(file, read_bvh(file, stated(file).metres_per_unit)); });
      else if (has_extension(file, ".amc"))
        attempt([&] { add(file, read_acclaim(file)); });
    if (motions_.empty() && errors_.empty())
      errors_.emplace_back(folder_.string(), 0, 0, "no-clips", "this folder holds no motion",
                           "put BVH files, or an ASF file and its AMC files, into it");
    throw_errors();
    return std::move(motions_);
  }

 private:
  template <typename Work>
  void attempt(const Work& work) {
    try {
      work();
    } catch (const content::ContentError& error) {
      errors_.push_back(error);
    }
  }

  StatedClip stated(const std::filesystem::path& file) const { return stated_for(stated_, file); }

  void add(const std::filesystem::path& file, RecordedMotion motion) {
    problems_.insert(problems_.end(), motion.notes.begin(), motion.notes.end());
    const StatedClip about = stated(file);
    motions_.push_back({.file = file.string(),
                        .motion = std::move(motion),
                        .role = about.role,
                        .motion_class = about.motion_class});
  }

  RecordedMotion read_acclaim(const std::filesystem::path& file) {
    const StatedClip about = stated(file);
    AcclaimOptions options{.metres_per_unit = about.metres_per_unit};
    if (about.frame_rate) options.frame_rate = *about.frame_rate;
    return read_amc(file, skeleton_of(file), options);
  }

  /// CMU names a motion after its skeleton: 16_12.amc belongs to 16.asf. The only ASF of a folder
  /// belongs to all.
  const AcclaimSkeleton& skeleton_of(const std::filesystem::path& amc) {
    std::vector<std::filesystem::path> skeletons;
    std::ranges::copy_if(files_, std::back_inserter(skeletons),
                         [](const auto& file) { return has_extension(file, ".asf"); });
    if (skeletons.size() > 1) {
      const std::string name = amc.stem().string();
      std::erase_if(skeletons, [&](const std::filesystem::path& asf) {
        const std::string stem = asf.stem().string();
        return name != stem && !name.starts_with(stem + "_");
      });
    }
    if (skeletons.size() != 1)
      throw content::ContentError(amc.string(), 0, 0, "no-skeleton",
                                  "no ASF file of this folder belongs to this motion",
                                  "put the skeleton beside it; 16_12.amc belongs to 16.asf");
    const auto known = acclaim_.find(skeletons[0]);
    if (known != acclaim_.end()) return known->second;
    return acclaim_.emplace(skeletons[0], read_asf(skeletons[0])).first->second;
  }

  void warn_of_unknown_clips() {
    for (const auto& [name, clip] : stated_.clip)
      if (std::ranges::none_of(files_, [&](const std::filesystem::path& file) {
            return file.stem() == name || file.filename() == name;
          }))
        problems_.push_back({.file = (folder_ / "clips.toml").string(),
                             .severity = Severity::Warning,
                             .code = "unknown-clip",
                             .message = fmt::format("no file here is called '{}'", name)});
  }

  void throw_errors() {
    if (errors_.empty()) return;
    for (std::size_t i = 0; i + 1 < errors_.size(); ++i)
      problems_.push_back(content::to_diagnostic(errors_[i]));
    throw content::ContentError(errors_.back());
  }

  std::filesystem::path folder_;
  std::vector<Diagnostic>& problems_;
  std::vector<std::filesystem::path> files_;
  StatedClips stated_;
  std::map<std::filesystem::path, AcclaimSkeleton> acclaim_;
  std::vector<FolderMotion> motions_;
  std::vector<content::ContentError> errors_;
};

}  // namespace

std::vector<FolderMotion> read_motion_folder(const std::filesystem::path& folder,
                                             std::vector<Diagnostic>& problems) {
  return FolderReader(folder, problems).read();
}

}  // namespace docent::import
