#pragma once

#include <filesystem>
#include <string_view>

namespace docent::test {

/// A committed file that is made of the programs' tables: fails where it is not that text, and says
/// how to write it anew: DOCENT_UPDATE_PAGES=1 in the environment of this test.
void expect_made(const std::filesystem::path& file, std::string_view text);

}  // namespace docent::test
