#pragma once

#include <string>
#include <string_view>

#include "content/import/collection/collection_object.h"

namespace docent::import {

/// Reads a IIIF Presentation manifest or collection, version 2 or 3: a manifest is one object, a
/// collection its members that are written out within it, and the addresses of the others. What is
/// odd but can be understood is a doubt. Throws ContentError with file, line and column for what is
/// no JSON, and for JSON that is neither.
Collection read_iiif(const std::string& file, std::string_view text);

}  // namespace docent::import
