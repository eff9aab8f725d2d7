#include "content/motion/compile_motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "content/content_error.h"
#include "content/import/motion/motion_folder.h"
#include "content/motion/cut_takes.h"
#include "content/motion/fewer_joints.h"
#include "content/motion/resample.h"
#include "content/motion/rest_pose.h"

namespace docent::motion::offline {
namespace {

constexpr double slowest_rate = 50;  // frames a second: at 30, feet are 5 mm off between frames

/// Do two recordings show the same body? Names and bones must agree, to a millimetre.
bool same_skeleton(const Skeleton& a, const Skeleton& b) {
  return std::ranges::equal(a.joint, b.joint, [](const Joint& p, const Joint& q) {
    return p.name == q.name && p.parent == q.parent && glm::distance(p.offset, q.offset) < 1e-3f;
  });
}

/// The skeleton that most recordings share; of equally many the one that comes first.
const Skeleton& commonest_skeleton(const std::vector<import::FolderMotion>& motions) {
  struct Kind {
    const Skeleton* skeleton;
    std::size_t count;
  };
  std::vector<Kind> kinds;  // Few, however many clips there are.
  for (const import::FolderMotion& m : motions) {
    const auto known = std::ranges::find_if(
        kinds, [&](const Kind& k) { return same_skeleton(*k.skeleton, m.motion.skeleton); });
    if (known == kinds.end())
      kinds.push_back({&m.motion.skeleton, 1});
    else
      ++known->count;
  }
  return *std::ranges::max_element(kinds, {}, &Kind::count)->skeleton;
}

/// Leaves out what a kiosk could not draw, and says so.
void leave_joints_out(Skeleton& skeleton, std::vector<SourceClip>& sources,
                      const std::string& folder, std::vector<Diagnostic>& problems) {
  const std::size_t before = skeleton.joint.size();
  if (before <= most_joints) return;
  const std::vector<std::size_t> kept = joints_of_parts(skeleton);
  if (kept.size() > most_joints)
    throw content::ContentError(
        folder, 0, 0, "too-many-joints",
        fmt::format("the body's limbs take {} joints, and a kiosk draws at most {}", kept.size(),
                    most_joints),
        "export the recording with a plainer skeleton");
  skeleton = with_joints(skeleton, kept);
  for (SourceClip& source : sources) source.clip = with_joints(source.clip, kept);
  problems.push_back({.file = folder,
                      .severity = Severity::Warning,
                      .code = "joints-left-out",
                      .message = fmt::format("{} of the skeleton's {} joints are left out, because "
                                             "a kiosk draws at most {}",
                                             before - kept.size(), before, most_joints),
                      .hint = "they are fingers and the like, which no walk needs"});
}

/// Cuts takes whose roles nobody stated, and says so.
std::vector<SourceClip> cut_takes(const Skeleton& skeleton, std::vector<SourceClip> sources,
                                  std::vector<Diagnostic>& problems) {
  std::vector<SourceClip> all;
  for (SourceClip& source : sources) {
    std::vector<MotionClip> parts;
    if (!source.role_stated) parts = cut_take(skeleton, source.clip);
    if (parts.size() < 2) {
      all.push_back(std::move(source));
      continue;
    }
    problems.push_back(
        {.file = source.file,
         .severity = Severity::Warning,
         .code = "cut-take",
         .message = fmt::format("this take stands, walks and stands again, and was cut into {} "
                                "clips",
                                parts.size()),
         .hint = "nothing needs to be done; 'role' in clips.toml keeps it whole"});
    for (MotionClip& part : parts) all.push_back({.clip = std::move(part), .file = source.file});
  }
  return all;
}

}  // namespace

MotionGraph compile_motion(std::span<const std::filesystem::path> folders,
                           const MotionOptions& options, std::vector<Diagnostic>& problems) {
  std::vector<import::FolderMotion> motions;
  for (const std::filesystem::path& folder : folders)
    for (import::FolderMotion& motion : import::read_motion_folder(folder, problems))
      motions.push_back(std::move(motion));
  Skeleton skeleton = commonest_skeleton(motions);
  double rate = 0;
  for (const import::FolderMotion& m : motions)
    if (same_skeleton(m.motion.skeleton, skeleton)) rate = std::max(rate, m.motion.clip.frame_rate);
  // Between two frames joints turn straight on, and a planted foot leaves its place a little.
  if (rate < slowest_rate) rate *= std::ceil(slowest_rate / rate);

  std::vector<SourceClip> sources;
  for (import::FolderMotion& m : motions) {
    if (!same_skeleton(m.motion.skeleton, skeleton)) {
      problems.push_back({.file = m.file,
                          .severity = Severity::Warning,
                          .code = "other-skeleton",
                          .message = "this clip is of another body than most of the folder and is "
                                     "left out",
                          .hint = "keep the clips of one person in one folder"});
      continue;
    }
    MotionClip& clip = m.motion.clip;
    sources.push_back({.clip = clip.frame_rate == rate ? std::move(clip) : resample(clip, rate),
                       .file = m.file,
                       .role_stated = m.role.has_value()});
    if (m.role) sources.back().clip.role = *m.role;
    if (!m.motion_class.empty()) sources.back().clip.motion_class = m.motion_class;
  }
  if (!stands_at_rest(skeleton)) {
    std::vector<MotionClip*> clips;
    for (SourceClip& source : sources) clips.push_back(&source.clip);
    rest_upright(skeleton, clips);
  }
  leave_joints_out(skeleton, sources, folders.front().string(), problems);
  sources = cut_takes(skeleton, std::move(sources), problems);
  MotionOptions used = options;
  if (options.give_to_other) used.toe_rest = options.give_to_other(skeleton, sources);
  return make_motion_graph(skeleton, std::move(sources), folders.front().string(), used, problems);
}

MotionGraph compile_motion(const std::filesystem::path& folder, const MotionOptions& options,
                           std::vector<Diagnostic>& problems) {
  return compile_motion(std::span(&folder, 1), options, problems);
}

}  // namespace docent::motion::offline
