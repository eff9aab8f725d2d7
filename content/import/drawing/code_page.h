#pragma once

#include <string>
#include <string_view>

namespace docent::import {

/// The text of an old drawing as UTF-8. `code_page` is what the drawing states (`ANSI_1252`,
/// `ANSI_936`, `dos850`), or nothing. What is UTF-8 already stays as it is; letters that cannot be
/// read become the replacement character. Never fails.
std::string to_utf8(std::string_view bytes, std::string_view code_page);

}  // namespace docent::import
