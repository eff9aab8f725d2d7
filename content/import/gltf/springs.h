#pragma once

#include "content/import/gltf/model.h"
#include "content/import/gltf/source.h"

namespace docent::import::gltf {

/// A file has no more springs, and no more colliders, than that; what is beyond is left out.
inline constexpr std::size_t most_springs = 4000;

/// Springs and their colliders as VRM 1.0 (VRMC_springBone 1.0) or VRM 0.x (secondaryAnimation) has
/// them. A body walks without them: one that cannot be used is left out, and why is told in the
/// source's warnings.
void read_springs_1_0(Source& source, const Part& part, std::size_t nodes, Vrm& vrm);
void read_springs_0(Source& source, const Part& part, std::size_t nodes, Vrm& vrm);

}  // namespace docent::import::gltf
