#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace docent::test {

/// A small museum as its staff would write it, in a folder of its own that a test may spoil: a room
/// of 10 by 8 metres with a case in it and a closet that is walled off, two exhibits, two
/// languages.
class MuseumFolder {
 public:
  MuseumFolder() {
    write("museum.toml",
          "[museum]\n"
          "title.en = \"Small Museum\"\n"
          "title.ar = \"متحف صغير\"\n"
          "languages = [\"en\", \"ar\"]\n"
          "[[floor]]\n"
          "name = \"ground\"\n"
          "plan = \"ground.geojson\"\n"
          "[kiosk]\n"
          "position = [2.0, 2.0]\n"
          "facing = 90\n"
          "[ambient]\n"
          "count = 3\n"
          "[[room]]\n"
          "id = \"hall\"\n"
          "title.en = \"Hall\"\n"
          "title.ar = \"القاعة\"\n"
          "label = [5.0, 4.0]\n"
          "outline = [[0, 0], [10, 0], [10, 8], [0, 8]]\n");
    write("ground.geojson",
          "{\"type\": \"Feature\", \"properties\": {}, \"geometry\": {\"type\": \"MultiPolygon\",\n"
          "\"coordinates\": [[\n"
          "  [[0, 0], [10, 0], [10, 8], [0, 8], [0, 0]],\n"
          "  [[6, 4], [6, 5], [7, 5], [7, 4], [6, 4]]],\n"
          " [[[12, 0], [16, 0], [16, 4], [12, 4], [12, 0]]]]}}\n");
    write("exhibits/hall.toml",
          "[[exhibit]]\n"
          "id = \"jade-disc\"\n"
          "position = [6.5, 4.5]\n"
          "facing = 270\n"
          "image = \"images/disc.svg\"\n"
          "title.en = \"Jade disc\"\n"
          "title.ar = \"قرص اليشم\"\n"
          "text.en = \"A disc.\"\n"
          "text.ar = \"قرص.\"\n"
          "\n"
          "[[exhibit]]\n"
          "id = \"portrait\"\n"
          "position = [10.0, 4.0]\n"
          "facing = 180\n"
          "image = \"images/disc.svg\"\n"
          "title.en = \"Portrait\"\n"
          "title.ar = \"صورة\"\n");
    write("images/disc.svg",
          "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 20 10'>"
          "<circle cx='10' cy='5' r='4' fill='green'/></svg>\n");
  }

  [[nodiscard]] const std::filesystem::path& path() const { return folder_.path(); }
  [[nodiscard]] std::filesystem::path database() const { return output_.path() / "museum.db"; }

  void write(const std::string& file, std::string_view text) const {
    std::filesystem::create_directories((path() / file).parent_path());
    std::ofstream(path() / file, std::ios::binary) << text;
  }

  /// Replaces the first occurrence of a text in a file.
  void replace(const std::string& file, std::string_view old, std::string_view with) const {
    std::string text = text_of(path() / file);
    const std::size_t at = text.find(old);
    ASSERT_NE(at, std::string::npos) << file << " does not hold " << old;
    write(file, text.replace(at, old.size(), with));
  }

  /// docent-content compile of this folder, without motion.
  [[nodiscard]] ProgramRun compile(const std::string& options = {}) const {
    return run_program("docent-content", "compile '" + path().string() + "' -o '" +
                                             database().string() + "' --no-motion --quiet " +
                                             options);
  }

 private:
  TemporaryFolder folder_, output_;
};

}  // namespace docent::test
