#include "content/motion/enrich.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>

#include "content/content_error.h"
#include "content/motion/extract_root_motion.h"
#include "content/motion/mirror.h"
#include "content/motion/parametric_turns.h"

namespace docent::motion::offline {
namespace {

/// What a clip offers a walk that another may lack.
struct Offer {
  ClipRole role;
  std::string motion_class;
  double turned = 0;       ///< Radians, counter-clockwise.
  bool left_foot = false;  ///< Bears the body when the clip starts, stops, or has half turned.
};

std::vector<Placement> body_of(const Skeleton& skeleton, const MotionClip& clip) {
  return extract_root_motion(skeleton, clip, joint_positions(skeleton, clip));
}

double turned_by(const std::vector<Placement>& body) {
  return body.back().heading - body.front().heading;
}

/// Is it the left foot that bears the body at the first step of a start, the last of a stop, and in
/// the middle of a turn?
bool bears_on_left(const MotionClip& clip, const std::vector<Placement>& body) {
  const double half = (body.front().heading + body.back().heading) / 2;
  bool is_left = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t f = 0; f < body.size(); ++f) {
    const FootPlants feet = clip.plants[f];
    if (feet.left == feet.right) continue;
    const double away = clip.role == ClipRole::Start  ? static_cast<double>(f)
                        : clip.role == ClipRole::Stop ? static_cast<double>(body.size() - f)
                                                      : std::abs(body[f].heading - half);
    if (away >= nearest) continue;
    nearest = away;
    is_left = feet.left;
  }
  return is_left;
}

Offer offer_of(const Skeleton& skeleton, const MotionClip& clip) {
  const std::vector<Placement> body = body_of(skeleton, clip);
  return {clip.role, clip.motion_class, turned_by(body), bears_on_left(clip, body)};
}

bool is_alike(const Offer& a, const Offer& b) {
  constexpr double same_turn = 12 * std::numbers::pi / 180;
  return a.role == b.role && a.motion_class == b.motion_class &&
         std::abs(a.turned - b.turned) < same_turn &&
         (a.role == ClipRole::Walk || a.left_foot == b.left_foot);
}

std::vector<MotionClip> mirrored_clips(const Skeleton& skeleton,
                                       const std::vector<MotionClip>& clips,
                                       const std::string& folder) {
  const std::vector<std::size_t> counterpart = find_counterparts(skeleton, folder);
  std::vector<Offer> offers;
  for (const MotionClip& clip : clips) offers.push_back(offer_of(skeleton, clip));
  std::vector<MotionClip> made;
  for (const MotionClip& clip : clips) {
    MotionClip image = mirrored(counterpart, clip);
    const Offer offer = offer_of(skeleton, image);
    if (std::ranges::any_of(offers, [&](const Offer& o) { return is_alike(o, offer); })) continue;
    offers.push_back(offer);
    image.name += ", mirrored";
    made.push_back(std::move(image));
  }
  return made;
}

/// Cuts away what the clip it was made of has as well: the walking after a start, before a stop,
/// before and after a turn.
void trim(const Skeleton& skeleton, MotionClip& clip) {
  constexpr double blend_seconds = 0.5, little = 0.05;
  const std::vector<Placement> body = body_of(skeleton, clip);
  const std::vector<double> speed = body_speed(body, clip.frame_rate);
  const double walking = (1 - 2 * little) * std::ranges::max(speed), turned = turned_by(body);
  const auto is_before = [&](std::size_t f) {
    if (clip.role == ClipRole::Start) return false;
    if (clip.role == ClipRole::Stop) return speed[f] >= walking;
    return (body[f].heading - body.front().heading) / turned < little;
  };
  const auto is_after = [&](std::size_t f) {
    if (clip.role == ClipRole::Start) return speed[f] >= walking;
    if (clip.role == ClipRole::Stop) return false;
    return (body.back().heading - body[f].heading) / turned < little;
  };
  std::size_t first = 0, end = body.size();
  while (first + 1 < end && is_before(first)) ++first;
  while (end > first + 1 && is_after(end - 1)) --end;
  const std::size_t edge = frames_in(blend_seconds, clip.frame_rate);
  first -= std::min(first, edge);
  end = std::min(end + edge, body.size());
  const auto cut = [&](auto& values, std::size_t per_frame) {
    using Values = std::remove_reference_t<decltype(values)>;
    const auto at = [&](std::size_t frame) {
      return values.begin() + static_cast<std::ptrdiff_t>(frame * per_frame);
    };
    values = Values(at(first), at(end));
  };
  cut(clip.root, 1);
  cut(clip.plants, 1);
  cut(clip.rotation, clip.joint_count);
}

}  // namespace

std::vector<MotionClip> enrich(const Skeleton& skeleton, const std::vector<MotionClip>& clips,
                               const std::vector<PoseCloud>& cloud, Enrichment enrichment,
                               const std::string& folder, std::vector<Diagnostic>& warnings) {
  std::vector<MotionClip> made;
  if (enrichment.turns) made = parametric_turns(skeleton, clips, cloud);
  if (enrichment.mirrored) {
    std::vector<MotionClip> all = clips;
    all.insert(all.end(), made.begin(), made.end());
    try {
      std::ranges::move(mirrored_clips(skeleton, all, folder), std::back_inserter(made));
    } catch (const content::ContentError& error) {
      warnings.push_back(content::to_diagnostic(error));
      warnings.back().severity = Severity::Warning;
    }
  }
  for (MotionClip& clip : made) trim(skeleton, clip);
  return made;
}

}  // namespace docent::motion::offline
