#include "runtime/input/touch_quirks.h"

#include <algorithm>
#include <array>

namespace docent::input {
namespace {

using Valid = TouchRules::Valid;
using Identity = TouchRules::Identity;
using Missing = TouchRules::Missing;
using Count = TouchRules::Count;

/// Mentions the fingers that are down and no others, and its count may be wrong.
constexpr TouchRules unseen_has_gone{
    .valid = Valid::WithTip, .missing = Missing::HasGone, .count = Count::EndsTheFrame};
/// Fills a report's free places with what was there before; confidence says which are meant.
constexpr TouchRules confident_only{.valid = Valid::WithConfidence, .count = Count::EndsTheFrame};
constexpr TouchRules confident_from_one{.valid = Valid::WithConfidence,
                                        .identity = Identity::IdentifierFromOne,
                                        .count = Count::EndsTheFrame};
/// Identifiers mean nothing: the first finger is the first of the report.
constexpr TouchRules in_range_by_position{
    .valid = Valid::InRange, .identity = Identity::Position, .count = Count::EndsTheFrame};

constexpr const char* counts_wrongly = "leaves a finger out when it has gone; count not kept";
constexpr const char* stale_places = "keeps old values in the places that it does not use";
constexpr const char* ids_from_one = "identifiers begin at 1; a place with 0 is free";
constexpr const char* no_identifiers = "identifiers do not stay with a finger";

/// Source: the class of behaviour that Linux 6.1's hid-multitouch gives these devices. Those marked
/// "compared" were also played from a recording beside the kernel's own events
///; the others were entered without one, and only where
/// nothing in a descriptor tells the class. A device of the Windows 8 kind is never looked up: its
/// specification leaves nothing open. In the order of their numbers.
constexpr std::array table{
    TouchQuirk{0x0408, 0x3000, confident_only, stale_places},          // Quanta, compared
    TouchQuirk{0x0408, 0x3001, confident_only, stale_places},          // Quanta
    TouchQuirk{0x0408, 0x3003, confident_only, stale_places},          // Quanta
    TouchQuirk{0x0408, 0x3008, confident_only, stale_places},          // Quanta, compared
    TouchQuirk{0x0483, 0x3261, confident_only, stale_places},          // Stantum by STM
    TouchQuirk{0x0486, 0x0185, confident_from_one, ids_from_one},      // Asus T91MT, compared
    TouchQuirk{0x0486, 0x0186, confident_from_one, ids_from_one},      // Asus
    TouchQuirk{0x04da, 0x1044, unseen_has_gone, counts_wrongly},       // Panasonic UBT780
    TouchQuirk{0x04da, 0x104d, unseen_has_gone, counts_wrongly},       // Panasonic UBT880
    TouchQuirk{0x0603, 0x0600, unseen_has_gone, counts_wrongly},       // Novatek
    TouchQuirk{0x062a, 0x7100, confident_from_one, ids_from_one},      // Turbox
    TouchQuirk{0x093a, 0x8001, in_range_by_position, no_identifiers},  // PixArt
    TouchQuirk{0x093a, 0x8002, in_range_by_position, no_identifiers},  // PixArt
    TouchQuirk{0x093a, 0x8003, in_range_by_position, no_identifiers},  // PixArt
    TouchQuirk{0x0dfc, 0x0003, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0dfc, 0x0100, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0dfc, 0x0101, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0dfc, 0x0102, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0dfc, 0x0106, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0dfc, 0x010a, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0dfc, 0xe100, unseen_has_gone, counts_wrongly},       // General Touch
    TouchQuirk{0x0fb8, 0x1109, unseen_has_gone, counts_wrongly},       // Wistron
    TouchQuirk{0x1403, 0x5001, confident_only, stale_places},          // Sitronix, compared
    TouchQuirk{0x1477, 0x1006, unseen_has_gone, counts_wrongly},       // Xiroku SPX
    TouchQuirk{0x1477, 0x1007, unseen_has_gone, counts_wrongly},       // Xiroku MPX
    TouchQuirk{0x1477, 0x100e, unseen_has_gone, counts_wrongly},       // Xiroku CSR
    TouchQuirk{0x1477, 0x1021, unseen_has_gone, counts_wrongly},       // Xiroku SPX1
    TouchQuirk{0x1477, 0x1022, unseen_has_gone, counts_wrongly},       // Xiroku CSR1
    TouchQuirk{0x1477, 0x1023, unseen_has_gone, counts_wrongly},       // Xiroku MPX1
    TouchQuirk{0x1477, 0x1024, unseen_has_gone, counts_wrongly},       // Xiroku SPX2
    TouchQuirk{0x1477, 0x1025, unseen_has_gone, counts_wrongly},       // Xiroku CSR2
    TouchQuirk{0x1477, 0x1026, unseen_has_gone, counts_wrongly},       // Xiroku MPX2
    TouchQuirk{0x1aad, 0x000f, unseen_has_gone, counts_wrongly},       // GoodTouch
    TouchQuirk{0x1e5e, 0x0313, unseen_has_gone, counts_wrongly},       // Touch International
    TouchQuirk{0x1f87, 0x0002, confident_only, stale_places},          // Stantum
    TouchQuirk{0x1ff7, 0x0013, unseen_has_gone, counts_wrongly},       // CVTouch, compared
    TouchQuirk{0x202e, 0x0006, confident_from_one, ids_from_one},      // Lumio, compared
    TouchQuirk{0x202e, 0x0007, confident_from_one, ids_from_one},      // Lumio
    TouchQuirk{0x2087, 0x0a01, in_range_by_position, no_identifiers},  // Cando
    TouchQuirk{0x2087, 0x0b03, in_range_by_position, no_identifiers},  // Cando
    TouchQuirk{0x2087, 0x0f01, in_range_by_position, no_identifiers},  // Cando
    TouchQuirk{0x20b3, 0x0a18, unseen_has_gone, counts_wrongly},       // Hanvon, compared
    TouchQuirk{0x2101, 0x1011, confident_from_one, ids_from_one},      // ActionStar
    TouchQuirk{0x222a, 0x0001, unseen_has_gone, counts_wrongly},       // Ilitek
    TouchQuirk{0x2247, 0x0001, unseen_has_gone, counts_wrongly},       // Chunghwa
    TouchQuirk{0x227d, 0x0709, unseen_has_gone, counts_wrongly},       // Unitec
    TouchQuirk{0x227d, 0x0a19, unseen_has_gone, counts_wrongly},       // Unitec
    TouchQuirk{0x22ed, 0x1010, unseen_has_gone, counts_wrongly},       // Hanvon
    TouchQuirk{0x2453, 0x0100, unseen_has_gone, counts_wrongly},       // Baanto
    TouchQuirk{0x24b8, 0x0020, unseen_has_gone, counts_wrongly},       // CJTouch
    TouchQuirk{0x24b8, 0x0040, unseen_has_gone, counts_wrongly},       // CJTouch
    TouchQuirk{0x2505, 0x0220, unseen_has_gone, counts_wrongly},       // XAT
    TouchQuirk{0x25b5, 0x0002, unseen_has_gone, counts_wrongly},       // FlatFrog
};

constexpr std::uint32_t number_of(const TouchQuirk& quirk) noexcept {
  return static_cast<std::uint32_t>(quirk.vendor) << 16U | quirk.product;
}
static_assert(std::ranges::is_sorted(table, {}, number_of));

}  // namespace

std::span<const TouchQuirk> known_quirks() noexcept {
  return table;
}

const TouchQuirk* quirk_of(std::uint16_t vendor, std::uint16_t product) noexcept {
  const auto wanted = static_cast<std::uint32_t>(vendor) << 16U | product;
  const auto* const at = std::ranges::lower_bound(table, wanted, {}, number_of);
  return at != table.end() && number_of(*at) == wanted ? at : nullptr;
}

}  // namespace docent::input
