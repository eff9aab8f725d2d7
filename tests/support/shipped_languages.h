#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "config/museum_config.h"
#include "runtime/model/museum.h"
#include "tests/support/reference_data.h"

namespace docent::test {

inline constexpr std::array<std::string_view, 12> shipped_languages{
    "en", "zh", "ja", "ko", "ar", "he", "hi", "th", "de", "fr", "es", "ru"};

/// The museum with words in every language that docent ships; those that it has come first. What
/// staff wrote stays in its own languages.
inline Museum in_all_shipped_languages(Museum museum) {
  for (const std::string_view tag : shipped_languages) {
    if (std::ranges::find(museum.languages, tag, &Language::tag) != museum.languages.end())
      continue;
    const config::WordsFile file =
        config::load_words(source_dir() / "config/words" / (std::string(tag) + ".toml"),
                           std::string(tag))
            .value.value();
    Language& language = museum.languages.emplace_back();
    language.tag = tag;
    language.name = file.name.value;
    language.right_to_left = file.direction.value == "right-to-left";
    for (const auto& [key, value] : file.words.value) language.words[key] = value.value;
  }
  return museum;
}

}  // namespace docent::test
