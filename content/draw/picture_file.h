#pragma once

#include <filesystem>
#include <string_view>

namespace docent::draw {

/// Writes a drawing in the place of a file, whole or not at all: as it is where the name ends in
/// .svg, painted by librsvg and cairo where it ends in .png. Throws ContentError of the kind
/// WrongUsage for any other name, Environment where the disk says no.
void write_picture(const std::filesystem::path& file, std::string_view svg);

}  // namespace docent::draw
