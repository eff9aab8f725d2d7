#pragma once

#include <string>
#include <string_view>

namespace docent::import {

/// A text as a screen shows it: of HTML the tags, remarks, scripts and styles are gone, `<br>` and
/// the ends of paragraphs are line ends, and entities are their letters. Any text is answered; one
/// without `<` and `&` comes back as it is.
std::string plain_text(std::string_view html);

}  // namespace docent::import
