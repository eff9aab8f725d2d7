#pragma once

#include <cstdint>

#include "runtime/interface/sheet.h"

namespace docent::interface {

/// The captions of the video that is drawn in `picture`, an index into Museum::pictures: on its
/// lower edge, in the visitor's language where there are any, a page at a time where one is longer
/// than two fifths of the picture have room for; for two lines of it, larger letters become smaller
/// again, down to the usual. They become View::cues.
void draw_cues(Sheet& sheet, const PixelBox& picture, std::uint32_t index);

/// The captions of a sound that plays, an index into Museum::sounds: below the middle of what is
/// left to the model, where also what is spoken is read, above all that lies there. They become
/// View::cues in place of a video's.
void draw_sound_cues(Sheet& sheet, const PixelBox& free, std::uint32_t sound);

}  // namespace docent::interface
