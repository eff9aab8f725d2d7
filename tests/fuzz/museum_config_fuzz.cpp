#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <system_error>

#include "config/museum_config.h"
#include "tests/fuzz/scratch_folder.h"

using namespace docent;

namespace {

/// "exhibits/NAME.toml" or "words/NAME.toml" of what a line asks for; nothing leaves the folder.
std::string file_asked_for(std::string_view line) {
  std::string name;
  for (const char c : line.substr(std::min<std::size_t>(line.size(), 1)))
    if (c != '/' && c != '\0' && name.size() < 40) name += c;
  return (line.starts_with('w') ? "words/" : "exhibits/") + name + ".toml";
}

/// Lays a museum's folder out. The text is museum.toml; a line "%%eNAME" or "%%wNAME" begins a file
/// of exhibits or words.
void lay_out(const test::ScratchFolder& folder, std::string_view text) {
  std::error_code ignored;
  for (const char* part : {"exhibits", "words"}) {
    std::filesystem::remove_all(folder.path() / part, ignored);
    std::filesystem::create_directory(folder.path() / part, ignored);
  }
  constexpr std::string_view mark = "\n%%";
  std::string file = "museum.toml";
  for (int count = 0; count < 8; ++count) {
    const std::size_t end = std::min(text.find(mark), text.size());
    static_cast<void>(folder.write(file, text.substr(0, end)));
    if (end == text.size()) return;
    text.remove_prefix(end + mark.size());
    const std::size_t line = std::min(text.find('\n'), text.size());
    file = file_asked_for(text.substr(0, line));
    text.remove_prefix(std::min(line + 1, text.size()));
  }
}

bool has_error(const std::vector<Diagnostic>& mistakes) {
  return std::ranges::any_of(mistakes,
                             [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

/// What the content compiler takes for granted of a museum without mistakes.
bool keeps_its_promises(const config::MuseumConfig& museum) {
  if (museum.languages.empty() || museum.floors.empty()) return false;
  std::set<std::string> ids;
  for (const config::ExhibitSection& exhibit : museum.exhibits) {
    if (!ids.insert(exhibit.id.value).second) return false;
    if (config::floor_index(museum, exhibit.floor.value) >= museum.floors.size()) return false;
  }
  for (const config::RoomSection& room : museum.rooms)
    if (config::floor_index(museum, room.floor.value) >= museum.floors.size()) return false;
  return config::floor_index(museum, museum.kiosk.floor.value) < museum.floors.size() &&
         museum.words.size() <= museum.languages.size();
}

}  // namespace

/// Whatever staff write into a museum's files: every mistake is a sentence about one of the files,
/// and a museum without errors keeps what the compiler relies on.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const test::ScratchFolder folder("museum-config");
  lay_out(folder, {reinterpret_cast<const char*>(data), size});
  const config::Loaded<config::MuseumConfig> loaded = config::load_museum_config(folder.path());
  for (const Diagnostic& mistake : loaded.diagnostics)
    if (mistake.message.empty() || mistake.file.empty()) __builtin_trap();
  if (has_error(loaded.diagnostics)) return 0;
  if (!loaded.value || !keeps_its_promises(*loaded.value)) __builtin_trap();
  return 0;
}
