#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace docent::compile {

/// The pictures that an SVG drawing links to by name instead of holding them: nothing is read from
/// beside a drawing, so they would be missing from it. In the order of the text; any bytes are
/// answered.
std::vector<std::string> linked_pictures(std::string_view svg);

}  // namespace docent::compile
