#include "content/compile/own_figure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "content/avatar/avatar.h"
#include "content/character/retarget.h"
#include "content/character/sheet.h"
#include "content/compile/shipped_files.h"
#include "content/content_error.h"
#include "content/import/motion/motion_folder.h"
#include "content/motion/foot_plants.h"
#include "content/parallel.h"

namespace docent::compile {
namespace {

Diagnostic note(const std::string& file, const std::string& message) {
  return {.file = file, .severity = Severity::Warning, .code = "character", .message = message};
}

/// Finds the plants of clips and levels them to one ground; the height at which toe joints rest.
double stand_on_ground(const Skeleton& skeleton, std::vector<motion::offline::SourceClip>& clips,
                       unsigned jobs) {
  namespace off = motion::offline;
  std::vector<double> heights(clips.size());
  content::for_each_index(clips.size(), jobs, [&](std::size_t c) {
    const off::JointPositions track = off::joint_positions(skeleton, clips[c].clip);
    off::find_foot_plants(skeleton, track, clips[c].clip);
    heights[c] = off::planted_height(skeleton, track, clips[c].clip);
  });
  const double rest = off::rest_height(skeleton, heights);
  for (std::size_t c = 0; c < clips.size(); ++c)
    off::level_ground(rest - heights[c], clips[c].clip);
  return rest;
}

/// Are these the proportions of an adult, whom our own bodies are modelled on?
bool is_like_ours(const character::Measures& m, const character::Fit& fit) {
  constexpr float usual_toe = 0.025F;
  const float hips = m.hip / m.crown, shoulders = m.shoulder.y / m.crown;
  return hips > 0.46F && hips < 0.60F && shoulders > 0.74F && shoulders < 0.88F && m.crown > 1.3F &&
         std::abs(fit.toe_rest - usual_toe * fit.legs) < 0.015F;
}

}  // namespace

OwnFigure::OwnFigure(const std::filesystem::path& model, std::vector<Diagnostic>& problems)
    : character_{character::read_character(model)},
      measures_{character::measure(character_)},
      problems_{problems} {
  for (const std::string& lost : character_.notes) problems.push_back(note(character_.file, lost));
  if (measures_.scale != 1)
    problems.push_back(note(
        character_.file,
        fmt::format("it is {:.2f} m high, which is no guide's height, and is made {:.2f} m high",
                    measures_.height / measures_.scale, measures_.height)));
}

double OwnFigure::take(Skeleton& skeleton, std::vector<motion::offline::SourceClip>& clips,
                       unsigned jobs) {
  const double rest = stand_on_ground(skeleton, clips, jobs);
  const character::Fit fit = character::fit_skeleton(skeleton, measures_, static_cast<float>(rest));
  body_ = character::bind_body(character_, measures_, fit);
  if (body_.cloth.node.size() < character_.swinging.bone.size())
    problems_.push_back(note(
        character_.file,
        fmt::format(
            "of its {} bones that swing a guide has {}; the ends of chains that carry least go "
            "with what they hang on",
            character_.swinging.bone.size(), body_.cloth.node.size())));
  std::vector<const MotionClip*> walks;
  for (const motion::offline::SourceClip& source : clips) walks.push_back(&source.clip);
  const float spread = character::spread_for(fit, body_, walks);
  if (spread > 0)
    problems_.push_back(
        note(character_.file, fmt::format("its arms are held {:.0f} degrees further out, so that "
                                          "they are free of its trunk",
                                          spread * 180 / std::numbers::pi)));
  content::for_each_index(clips.size(), jobs, [&](std::size_t c) {
    clips[c].clip = character::retarget(fit, clips[c].clip, spread);
  });
  skeleton = fit.skeleton;
  is_like_ours_ = is_like_ours(measures_, fit);
  return fit.toe_rest;
}

SkinnedMesh OwnFigure::among_others(const Skeleton& skeleton, unsigned jobs) const {
  if (!is_like_ours_) return body_;  // so strollers look like the guide
  SkinnedMesh all = avatar::make_avatars(skeleton, jobs);
  const std::vector<Mat4> ours = all.inverse_bind;
  for (std::size_t f = 1; f < all.figure_end.size(); ++f)
    all.inverse_bind.insert(all.inverse_bind.end(), ours.begin(), ours.end());
  all.inverse_bind.insert(all.inverse_bind.end(), body_.inverse_bind.begin(),
                          body_.inverse_bind.end());
  const auto first = static_cast<std::uint32_t>(all.vertices.size());
  all.vertices.insert(all.vertices.end(), body_.vertices.begin(), body_.vertices.end());
  for (const std::uint32_t v : body_.indices) all.indices.push_back(first + v);
  all.figure_end.push_back(static_cast<std::uint32_t>(all.indices.size()));
  all.colour = body_.colour;
  const auto figure = static_cast<std::uint8_t>(all.figure_end.size() - 1);
  for (ClothNode node : body_.cloth.node) node.figure = figure, all.cloth.node.push_back(node);
  for (ClothCollider limb : body_.cloth.collider)
    limb.figure = figure, all.cloth.collider.push_back(limb);
  return all;
}

Pixels draw_own_figure(const character::Character& character) {
  std::vector<Diagnostic> problems;
  std::vector<motion::offline::SourceClip> clips;
  Skeleton skeleton;
  for (import::FolderMotion& read : import::read_motion_folder(shipped_clips(), problems)) {
    skeleton = read.motion.skeleton;
    clips.push_back({.clip = std::move(read.motion.clip), .file = read.file});
  }
  const double rest = stand_on_ground(skeleton, clips, 1);
  const character::Measures measures = character::measure(character);
  const character::Fit fit = character::fit_skeleton(skeleton, measures, static_cast<float>(rest));
  const SkinnedMesh body = character::bind_body(character, measures, fit);
  const auto walk = std::ranges::find(clips, "walk", [](const auto& c) { return c.clip.name; });
  const MotionClip& shown = (walk == clips.end() ? clips.front() : *walk).clip;
  const MotionClip* one = &shown;
  const float spread = character::spread_for(fit, body, {&one, 1});
  return character::draw_sheet(fit.skeleton, body, character::retarget(fit, shown, spread));
}

}  // namespace docent::compile
