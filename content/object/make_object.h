#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "content/object/stand_up.h"
#include "runtime/model/exhibit/object.h"

namespace docent::object {

/// An exhibit's object, and what was mended, guessed or left out of its file: sentences.
struct MadeObject {
  ExhibitObject object;
  std::vector<std::string> warnings;  ///< Of what the file has wrong.
  std::vector<std::string> notes;     ///< Of what was guessed, and staff may want to say.
  std::size_t triangles = 0;          ///< In the file.
};

/// Makes an object of a file that was read: upright, in metres, standing on its base, of at most
/// ObjectDetail::most_triangles and ExhibitObject::most_bytes, and of so many triangles from afar.
/// The same file gives the same bytes. ContentError (`unreadable-model`) where there is nothing to
/// see.
MadeObject make_object(const import::object::ObjectFile& source, const std::string& file,
                       const ObjectWish& wish = {},
                       std::size_t distant_triangles = ExhibitObject::most_distant_triangles);

}  // namespace docent::object
