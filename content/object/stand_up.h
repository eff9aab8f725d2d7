#pragma once

#include <optional>
#include <string>
#include <vector>

#include "content/import/object/read_object.h"
#include "content/object/shape.h"

namespace docent::object {

/// What staff say of an object where its file does not, or is wrong.
struct ObjectWish {
  std::optional<double> height;  ///< Metres, as it stands.
  std::optional<import::object::UpAxis> up;
};

/// Turns the shape upright (y up), stands it on y = 0 with its middle over the origin, and scales
/// it to metres.
///
/// Files that do not say which way is up are believed to be as their kind usually is, but where
/// they would stand on a point one way and on a broad foot the other. A file without a unit is in
/// metres where that makes it at most 5 m large, else in millimetres, or in centimetres where those
/// would make it smaller than 2 cm; a glTF file, which has metres by rule, too where it would be
/// larger, and is told of then. What was guessed is in `notes`.
void stand_up(const import::object::ObjectFile& file, const ObjectWish& wish, Shape& shape,
              std::vector<std::string>& notes);

}  // namespace docent::object
