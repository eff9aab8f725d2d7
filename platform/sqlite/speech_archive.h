#pragma once

#include <filesystem>
#include <memory>
#include <span>

#include "runtime/model/speech.h"
#include "runtime/sound/sound_archive.h"

namespace docent::sqlite {

/// The sounds of a database file, which is held open: another that takes its name changes nothing.
/// Null where the file does not hold just this speech, in this order.
std::unique_ptr<sound::SoundArchive> open_speech_archive(const std::filesystem::path& file,
                                                         std::span<const SpeechSound> speech);

}  // namespace docent::sqlite
