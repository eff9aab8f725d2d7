#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/support/run_program.h"
#include "tests/support/sample_database.h"
#include "tests/support/temporary_folder.h"

namespace docent::test {

/// A folder with a visit in it, in which the kiosk runs headless.
class VisitRun {
 public:
  explicit VisitRun(const std::string& visit) {
    std::ofstream(folder_.path() / "a.visit") << visit;
  }

  /// Plays the visit; `more` are further arguments.
  ProgramRun play(const std::string& more = "", const std::string& size = "320x180") const {
    return run_program("docent", "--content '" + sample_database().string() +
                                     "' --display headless --size " + size + " --visit '" +
                                     (folder_.path() / "a.visit").string() + "' " + more);
  }

  std::filesystem::path file(const char* name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

/// A number of a flat JSON object; not a number where the key is missing.
inline double number_in(const std::string& json, const std::string& key) {
  const std::size_t at = json.find('"' + key + "\":");
  return at == std::string::npos ? std::nan("") : std::stod(json.substr(at + key.size() + 3));
}

}  // namespace docent::test
