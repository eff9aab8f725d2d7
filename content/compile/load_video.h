#pragma once

#include <filesystem>
#include <span>
#include <string>

#include "runtime/model/museum.h"
#include "runtime/video/webm.h"

namespace docent::compile {

/// A video that a kiosk can play, and the picture that stands for it.
struct LoadedVideo {
  video::Video video;
  std::string bytes;    ///< Of its file, as it is.
  EncodedImage poster;  ///< Its first frame, whole; a JPEG.
};

/// Does a file begin as WebM and Matroska do? False too where it cannot be read.
bool is_video(const std::filesystem::path& file);

/// Reads a WebM video and decodes all of it, to see that it is whole, keeps to `limits` and is as
/// large as it says. `name` is what the museum calls it. Throws ContentError (`unreadable-video`)
/// with the sentence of what is wrong, and how a film becomes such a video.
LoadedVideo load_video(const std::filesystem::path& file, const std::string& name,
                       const video::Limits& limits = {});

}  // namespace docent::compile
