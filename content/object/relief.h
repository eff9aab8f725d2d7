#pragma once

#include <string>

#include "content/import/object/read_object.h"
#include "runtime/model/pixels.h"

namespace docent::object {

/// Makes a standing relief of a photograph whose ground is clear or of one colour: its outline with
/// such holes as are large, with the picture on its front and, as seen through, on its back. Both
/// swell where the outline is far, and a rim joins them: a closed surface, every triangle
/// counter-clockwise from outside, y up, 1 high. Its outline is within a pixel of the picture's.
/// ContentError (`busy-picture`) about `file` where nothing tells the thing from its ground.
import::object::ObjectFile relief_of(const Pixels& picture, const std::string& file);

}  // namespace docent::object
