#pragma once

#include <span>
#include <vector>

#include "runtime/model/diagnostic.h"

namespace docent::config {

/// Of diagnostics that say the same of many things, the first three, the last of which says how
/// many more there are; the others as they are. Alike are those of one code and severity whose
/// sentences differ in numbers and in what stands in quotation marks only. Up to five are told
/// one by one.
std::vector<Diagnostic> without_alike(std::span<const Diagnostic> diagnostics);

}  // namespace docent::config
