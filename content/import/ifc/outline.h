#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "content/import/ifc/step_file.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// Where a product stands (IfcLocalPlacement and all it is relative to), in the file's unit.
glm::dmat4 placement_of(const StepFile& step, const StepValue& placement);

/// The outlines on the ground of a product's shape, outer ring first, then what is cut out of it:
/// of extruded profiles, boundary representations, face sets and footprint curves, whichever covers
/// most. `shape` is the product's Representation; `world` its placement.
std::vector<std::vector<Vec2>> outline_of(const StepFile& step, const StepValue& shape,
                                          const glm::dmat4& world);

/// Points of a product's shape: corners of all its bodies; at most 20,000.
std::vector<glm::dvec3> points_of(const StepFile& step, const StepValue& shape,
                                  const glm::dmat4& world);

/// Points of the plane, curve or surface with which a space ends at an element.
std::vector<glm::dvec3> points_of_item(const StepFile& step, const StepValue& item,
                                       const glm::dmat4& world);

}  // namespace docent::import
