#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "config/diagnostic_text.h"
#include "content/character/character.h"
#include "content/character/fit.h"
#include "content/command/commands.h"
#include "content/compile/own_figure.h"
#include "content/content_error.h"
#include "content/import/gltf/read_model.h"
#include "platform/image/image.h"

namespace docent::command {
namespace {

struct FigureOptions {
  std::string model, sheet;
  bool json = false;
};

/// What a character would be as a guide.
nlohmann::ordered_json facts_of(const character::Character& it, const character::Measures& m) {
  nlohmann::ordered_json facts;
  facts["triangles_in"] = it.extent.triangles;
  facts["triangles"] = it.body.surface.indices.size() / 3;
  facts["joints"] = it.joints;
  const double height =
      static_cast<double>(it.extent.high.y) - static_cast<double>(it.extent.low.y);
  facts["height"] = std::round(height * 1e4) / 1e4;
  facts["rest_pose"] = character::name_of(it.standing.pose);
  facts["bones"] = nlohmann::ordered_json::object();
  for (std::size_t b = 0; b < character::bone_count; ++b)
    if (!it.bone_node[b].empty())
      facts["bones"][std::string(character::bone_names[b])] = it.bone_node[b];
  facts["springs"] = it.springs;
  facts["spring_bones"] = it.swinging.bone.size();
  facts["expressions"] = it.expressions;
  facts["scale"] = m.scale;
  facts["guide_height"] = std::round(static_cast<double>(m.height) * 1e4) / 1e4;
  return facts;
}

std::string sentence_of(const character::Character& it, const character::Measures& m) {
  return fmt::format(
      "{} bones of {} joints, rest pose {}, {:.2f} m high{}; {} triangles of {}, {} spring chains, "
      "{} expressions",
      std::ranges::count_if(it.bone_node, [](const std::string& n) { return !n.empty(); }),
      it.joints, character::name_of(it.standing.pose), it.extent.high.y - it.extent.low.y,
      m.scale == 1 ? std::string() : fmt::format(" ({:.2f} m as a guide)", m.height),
      it.body.surface.indices.size() / 3, it.extent.triangles, it.springs, it.expressions.size());
}

void tell_notes(const std::vector<std::string>& notes, const FigureOptions& options) {
  std::vector<Diagnostic> told;
  for (const std::string& note : notes)
    told.push_back({.file = options.model,
                    .severity = Severity::Warning,
                    .code = "character",
                    .message = note});
  config::tell(told, options.json ? config::DiagnosticForm::Json : config::DiagnosticForm::Text);
}

/// What was noticed in a file is told also where it is no character.
character::Character read(const FigureOptions& options) {
  const import::gltf::Model model = import::gltf::read_model(options.model);
  try {
    return character::make_character(model, options.model);
  } catch (const content::ContentError&) {
    tell_notes(model.warnings, options);
    throw;
  }
}

int run_figure(const FigureOptions& options) {
  const character::Character it = read(options);
  const character::Measures m = character::measure(it);
  tell_notes(it.notes, options);
  if (!options.sheet.empty()) {
    const Result<void> written = image::write_png(options.sheet, compile::draw_own_figure(it));
    if (!written) throw content::to_content_error(written.error(), options.sheet, "cannot-write");
  }
  fmt::print("{}\n", options.json ? facts_of(it, m).dump(-1, ' ', false,
                                                         nlohmann::json::error_handler_t::replace)
                                  : sentence_of(it, m));
  return 0;
}

}  // namespace

terminal::Command figure_command() {
  using terminal::Times;
  auto options = std::make_shared<FigureOptions>();
  return {.name = "figure",
          .manual = "says what a character (VRM, GLB, glTF) would be as a guide",
          .options =
              {
                  {"FILE", terminal::file("FILE.vrm|FILE.glb", options->model),
                   "The character: VRM 0.x or 1.0, GLB or glTF", Times::Once},
                  {"-o,--output", terminal::file("SHEET.png", options->sheet),
                   "Draw it: turned about, and walking", Times::AtMostOnce},
                  {"--json", terminal::flag(options->json), "Print the figures as JSON"},
              },
          .run = [options] { return run_figure(*options); }};
}

}  // namespace docent::command
