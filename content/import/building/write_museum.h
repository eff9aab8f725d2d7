#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "content/import/building/museum_text.h"
#include "runtime/model/diagnostic.h"

namespace docent::import {

/// Writes a museum's text files, or updates those that are there: what staff have changed since the
/// last import is kept, and each such place comes back as a warning, as does what the plan has
/// changed. The last import's own files are kept in the folder `imported`, to tell one from the
/// other. Each file appears whole or not at all. Throws ContentError where the disk refuses.
std::vector<Diagnostic> write_museum_folder(const std::filesystem::path& museum,
                                            std::span<const MuseumText> texts);

}  // namespace docent::import
