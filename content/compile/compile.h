#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "content/compile/progress.h"
#include "content/compile/report.h"
#include "content/import/floor/geojson.h"
#include "content/motion/enrich.h"
#include "runtime/model/museum.h"

namespace docent::compile {

/// What is to be compiled, and how.
struct CompileOptions {
  std::vector<std::string> sources;  ///< One museum folder, or GeoJSON files of one floor.
  std::vector<std::string> clips;    ///< Folders of recordings; empty: the museum's or else ours.
  motion::offline::Enrichment enrichment{};  ///< Clips to be made of those recorded.
  import::Coordinates coordinates = import::Coordinates::Metres;
  std::vector<double> radii;  ///< Radius classes beyond 0 and the museum's body radius, metres.
  bool with_motion = true;
  bool with_speech = true;
  std::vector<SpeechSound> speech_before{};  ///< Of the last compilation; what is the same is kept.
  bool only_check = false;  ///< Only the report is wanted: what cannot be wrong is left out.
  unsigned jobs = 0;  ///< Threads, the same result for any number; 0: as many as the machine has.
};

/// Makes a museum of its sources. Everything that is wrong with them goes into the report; the
/// museum is empty where any of it is an error.
std::optional<Museum> compile(const CompileOptions& options, Report& report, Progress& progress);

}  // namespace docent::compile
