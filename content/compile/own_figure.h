#pragma once

#include <filesystem>
#include <vector>

#include "content/character/character.h"
#include "content/character/fit.h"
#include "content/motion/make_motion_graph.h"

namespace docent::compile {

/// A museum's own character while it is made a guide: read first, given the clips, then put among
/// our own people, who are made to its measure.
class OwnFigure {
 public:
  /// ContentError where the model cannot be used; what is lost or was mended goes to `problems`.
  OwnFigure(const std::filesystem::path& model, std::vector<Diagnostic>& problems);

  /// Gives the clips and their skeleton the character's measures; the height at which its toe
  /// joints rest, metres.
  double take(Skeleton& skeleton, std::vector<motion::offline::SourceClip>& clips, unsigned jobs);

  /// All bodies: ours for strollers, where such a body can be made, and the character, the last.
  SkinnedMesh among_others(const Skeleton& skeleton, unsigned jobs) const;

 private:
  character::Character character_;
  character::Measures measures_;
  SkinnedMesh body_;
  bool is_like_ours_ = false;  ///< Our own people can have such a body.
  std::vector<Diagnostic>& problems_;
};

/// A character from all sides, and walking as the clips that docent ships have it.
Pixels draw_own_figure(const character::Character& character);

}  // namespace docent::compile
