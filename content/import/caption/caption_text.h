#pragma once

#include <string>
#include <string_view>

namespace docent::import {

/// The lines of a cue as a screen shows them (WebVTT, section 4.2.2): without tags, entities as
/// their letters, spaces one at a time, each line joined to the one before it unless it begins with
/// the dash of another who speaks. A `<` that begins no tag stays. Empty where nothing is left.
std::string caption_text(std::string_view lines);

}  // namespace docent::import
