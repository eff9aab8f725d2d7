#pragma once

#include <cstdint>
#include <vector>

#include "content/import/gltf/source.h"

namespace docent::import::gltf {

/// Numbers of an accessor, element after element.
struct Numbers {
  std::size_t components = 1;  ///< Of an element.
  std::size_t count = 0;       ///< Of elements.
  std::vector<float> value;    ///< Finite; whole numbers that are normalised lie in [-1, 1].
};
/// ContentError about the accessor where its elements are not there, or not finite.
Numbers read_numbers(Source& source, std::uint64_t accessor, const Part& asked_by);

/// Whole numbers that must not be normalised: indices, joints.
struct Indices {
  std::size_t components = 1, count = 0;
  std::vector<std::uint32_t> value;
};
Indices read_indices(Source& source, std::uint64_t accessor, const Part& asked_by);

/// The number of elements that an accessor claims to have.
std::size_t count_of(const Source& source, std::uint64_t accessor, const Part& asked_by);

}  // namespace docent::import::gltf
