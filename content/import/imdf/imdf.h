#pragma once

#include <map>
#include <string>
#include <string_view>

#include "content/import/building/imported_building.h"

namespace docent::import {

/// The text files of a ZIP archive by their names without folders. Throws ContentError for an
/// archive that is damaged, and for one that would unpack to more than 256 MB.
std::map<std::string, std::string> unpack_archive(const std::string& file, std::string_view bytes);

/// Is this a ZIP archive with the files of the Indoor Mapping Data Format?
bool is_imdf(std::string_view bytes);

/// Reads an IMDF archive (OGC 20-094): levels, units, openings, amenities, fixtures, kiosks,
/// sections, and the names of occupants where units have none; names in all languages. Throws
/// ContentError with the file in the archive and its place.
ImportedBuilding read_imdf(const BuildingSource& source, const ImportOptions& options);

}  // namespace docent::import
