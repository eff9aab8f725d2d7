#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "config/museum_path.h"
#include "runtime/model/diagnostic.h"

namespace docent::config {

/// The files of one of the museum's folders that are read, and what else lies there.
struct TomlFolder {
  std::vector<std::filesystem::path> files;  ///< In the order of their names.
  std::vector<Diagnostic> diagnostics;
};

/// Lists the TOML files of `name`, a folder of the museum's folder `museum`. A folder that is none,
/// or may not be read, is an error; a file that will not be read though staff may think so
/// (`hall.toml.txt`, `hall.TOML`, a folder in the folder) is a warning. Hidden files and those that
/// editors leave are passed over. A folder that is not there holds nothing; one of nearly that name
/// is a warning.
TomlFolder list_toml_files(const std::filesystem::path& museum, const std::string& name,
                           MuseumPaths& paths);

/// Warnings of TOML files in the museum's folder itself that nobody reads there.
std::vector<Diagnostic> stray_toml_files(const std::filesystem::path& museum);

}  // namespace docent::config
