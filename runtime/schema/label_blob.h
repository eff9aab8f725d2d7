#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "runtime/model/geometry/hub_labels.h"

/// A table of hub labels as bytes, most of a floor's database: about 9 bytes an entry, where its
/// numbers as they are take 16.
///
///   count        stations
///   each station:
///     count        its entries
///     each entry:
///       count        its hub less the one before (the first: the hub itself), less one
///       u32          its cost, low byte first
///       count        its link and one; 0 for HubLabels::roll
///       count        its parent among the station's entries, the first being 1; 0 without one
///
/// A count is written in groups of 7 bits, the low ones first, each in a byte whose high bit says
/// that more follow (LEB128, as in DWARF 4, section 7.6), in at most 5 bytes.
namespace docent::schema {

/// Hubs ascend within a station, and parents are entries of the same station.
std::vector<std::byte> encode(const LabelTable& table);

/// Replaces the table by the one that the bytes hold; false, and nothing changed, where they hold
/// none. Safe on any bytes: takes at most some twelve times their number of memory.
[[nodiscard]] bool decode(std::span<const std::byte> bytes, LabelTable& table);

}  // namespace docent::schema
