#pragma once

#include <filesystem>

namespace docent::write {

/// Writes FILE.zck beside a file, by the program zck of Debian's package zchunk: kiosks that have
/// an older one then fetch what differs. False where that did not work, and nothing is left; kiosks
/// fetch the whole file then.
bool write_zchunk(const std::filesystem::path& file);

}  // namespace docent::write
