#pragma once

#include <filesystem>
#include <string>

namespace docent::compile {

/// The clips that come with docent: of the installation that this program belongs to, else of the
/// source tree that it was built from.
std::filesystem::path shipped_clips();

/// The words of the interface in a language, for museums that have none of their own. May not
/// exist.
std::filesystem::path shipped_words(const std::string& language);

}  // namespace docent::compile
