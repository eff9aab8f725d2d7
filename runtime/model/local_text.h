#pragma once

#include <functional>
#include <map>
#include <string>

namespace docent {

/// Text by language tag (BCP 47: "en", "zh", "ar").
using LocalText = std::map<std::string, std::string, std::less<>>;

}  // namespace docent
