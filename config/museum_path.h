#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace docent::config {

/// Why a file that staff name cannot be taken.
struct PathFault {
  std::string code;     ///< `missing-file`, `outside-museum`, `bad-path`, `unreadable-file`.
  std::string message;  ///< A sentence about it.
  std::string label;    ///< A few words beside it.
  std::string hint;     ///< What to write instead.
};

/// What a name should be of. A text may be empty; other files may not.
enum class Wanted : std::uint8_t { File, Text, Folder, FileOrFolder };

/// Looks whether names, as they are written in a museum's files, are of something in the museum's
/// own folder that can be read: neither an absolute path, nor one that leads out of the folder by
/// itself or by a link, nor a device, a pipe, an empty file or one without permission. Opens no
/// file. A name in the wrong letter case, one that is nearly right and one of a file in another
/// folder of the museum are answered with the right one.
///
/// Remembers what lies in the museum's folders, so that a lost folder of thousands of pictures is
/// told quickly: make one for each run.
class MuseumPaths {
 public:
  explicit MuseumPaths(std::filesystem::path museum) : museum_(std::move(museum)) {}

  /// `name` is relative to the museum's folder.
  std::optional<PathFault> fault(const std::string& name, Wanted wanted = Wanted::File);

  /// Where in the museum a file of that name lies, whatever its letters' case; empty where none
  /// does.
  std::string elsewhere(const std::string& file_name);

 private:
  const std::vector<std::string>& names_in(const std::filesystem::path& folder);
  std::string in_right_case(const std::filesystem::path& name);
  std::string nearly(const std::filesystem::path& name);
  std::optional<PathFault> fault_of_words(const std::string& name);
  PathFault missing(const std::string& name, Wanted wanted);
  std::string where_it_is(const std::string& name);

  std::filesystem::path museum_;
  std::unordered_map<std::string, std::vector<std::string>> listed_;
  std::optional<std::unordered_map<std::string, std::string>> all_;  ///< Paths by names of files.
  std::size_t told_ = 0;
};

/// Is a file, links followed, within the folder, links followed?
bool is_within(const std::filesystem::path& folder, const std::filesystem::path& file);

}  // namespace docent::config
