#include "content/compile/shipped_files.h"

#include <system_error>

#include "platform/file/read_file.h"

namespace docent::compile {

namespace {

namespace fs = std::filesystem;

/// share/docent beside the bin folder that this program was installed in.
fs::path share_folder() {
  std::error_code unknown;
  const fs::path program = fs::read_symlink("/proc/self/exe", unknown);
  return program.parent_path().parent_path() / "share" / "docent";
}

fs::path installed_or(const fs::path& installed, const fs::path& in_sources) {
  return file::is_there(installed) ? installed : fs::path(DOCENT_SOURCE_DIR) / in_sources;
}

}  // namespace

fs::path shipped_clips() {
  return installed_or(share_folder() / "clips", "content/clips");
}

fs::path shipped_words(const std::string& language) {
  const std::string file = language + ".toml";
  return installed_or(share_folder() / "words" / file, fs::path("config/words") / file);
}

}  // namespace docent::compile
