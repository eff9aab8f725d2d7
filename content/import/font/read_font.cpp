#include "content/import/font/read_font.h"

#include <freetype/freetype.h>

#include <memory>
#include <string_view>

#include "content/content_error.h"
#include "platform/handle.h"

namespace docent::import {
namespace {

using Library = std::unique_ptr<FT_LibraryRec_, CloseWith<FT_Done_FreeType>>;
using Face = std::unique_ptr<FT_FaceRec_, CloseWith<FT_Done_Face>>;

content::ContentError unreadable(const std::string& why, const std::string& hint) {
  return {"", 0, 0, "unreadable-font", why, hint};
}

constexpr std::string_view ask = "ask who made it for the TTF or OTF file";

Face open_face(FT_Library library, std::span<const std::byte> bytes) {
  FT_Face opened = nullptr;
  if (FT_New_Memory_Face(library, reinterpret_cast<const FT_Byte*>(bytes.data()),
                         static_cast<FT_Long>(bytes.size()), 0, &opened) != 0)
    throw unreadable("this is no font, or a damaged one", std::string(ask));
  Face face(opened);
  if (face->num_faces > 1)
    throw unreadable("this file is a collection of several fonts",
                     "save each as a file of its own");
  if (!FT_IS_SCALABLE(face.get()))
    throw unreadable("this font holds pictures of letters for one size", "take one with outlines");
  return face;
}

/// Draws nothing: the outline of each letter is read once.
void look_at(FT_Face face, FT_UInt glyph, char32_t letter) {
  constexpr FT_Int32 flags = FT_LOAD_NO_SCALE | FT_LOAD_NO_BITMAP | FT_LOAD_IGNORE_TRANSFORM;
  if (FT_Load_Glyph(face, glyph, flags) == 0) return;
  char number[16];
  std::snprintf(number, sizeof number, "U+%04X", static_cast<unsigned>(letter));
  throw unreadable(std::string("this font is damaged: the outline of ") + number, std::string(ask));
}

}  // namespace

Font read_font(std::span<const std::byte> bytes) {
  FT_Library opened = nullptr;
  if (FT_Init_FreeType(&opened) != 0) throw unreadable("FreeType does not start", "try again");
  const Library library(opened);
  const Face face = open_face(library.get(), bytes);

  Font font;
  if (face->family_name != nullptr) font.family = face->family_name;
  if (font.family.empty() || font.family.contains(','))
    throw unreadable("the family of this font has no name, or one with a comma",
                     "give it another name, or take another font");
  if (FT_Select_Charmap(face.get(), FT_ENCODING_UNICODE) != 0)
    throw unreadable("this font has signs in place of letters", "take one with letters");
  FT_UInt glyph = 0;
  for (FT_ULong letter = FT_Get_First_Char(face.get(), &glyph); glyph != 0;
       letter = FT_Get_Next_Char(face.get(), letter, &glyph)) {
    look_at(face.get(), glyph, static_cast<char32_t>(letter));
    font.letters.push_back(static_cast<char32_t>(letter));
  }
  constexpr FT_UShort kinds = FT_FSTYPE_RESTRICTED_LICENSE_EMBEDDING |
                              FT_FSTYPE_PREVIEW_AND_PRINT_EMBEDDING | FT_FSTYPE_EDITABLE_EMBEDDING;
  font.forbids_embedding =
      (FT_Get_FSType_Flags(face.get()) & kinds) == FT_FSTYPE_RESTRICTED_LICENSE_EMBEDDING;
  return font;
}

}  // namespace docent::import
