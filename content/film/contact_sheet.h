#pragma once

#include <cstdint>
#include <span>

#include "runtime/model/pixels.h"

namespace docent::film {

/// Pictures of one size side by side, in rows of at most `columns`, in order. Nothing where there
/// is no picture; what no picture covers is opaque white.
Pixels contact_sheet(std::span<const Pixels> pictures, std::uint32_t columns);

/// How many columns make a sheet of so many pictures about twice as wide as high.
std::uint32_t sheet_columns(std::size_t pictures) noexcept;

}  // namespace docent::film
