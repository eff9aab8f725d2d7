#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "runtime/model/museum.h"
#include "runtime/video/webm.h"

namespace docent::compile {

/// A video that a kiosk can play.
struct LoadedVideo {
  EncodedImage image;      ///< With the bytes of its file, as it is (moving_picture.h).
  bool has_sound = false;  ///< Which nobody will hear.
};

/// Does a file begin as WebM and Matroska do? False too where it cannot be read.
bool is_video(const std::filesystem::path& file);

/// Reads a WebM video and decodes all of it, to see that it is whole, keeps to `limits` and is as
/// large as it says. `name` is what the museum calls it. Throws ContentError (`unreadable-video`)
/// with the sentence of what is wrong, and how a film becomes such a video. Its name ends in .webm.
LoadedVideo load_video(const std::filesystem::path& file, const std::string& name,
                       const video::Limits& limits = {});

}  // namespace docent::compile
