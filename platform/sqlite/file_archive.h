#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

#include "runtime/model/blob_archive.h"

namespace docent::sqlite {

/// What can stay in a database file: museum.speech[i].packets, museum.images[i].bytes,
/// museum.objects[i].detail.
enum class Archived : std::uint8_t { Speech, Images, Objects };

/// These bytes of a database file, by their index in the museum. The file is held open: another
/// that takes its name changes nothing. Null where it is not the file with that checksum
/// (checksum_text), or cannot be read. The bytes were checked when the museum was read; what a disk
/// or somebody does to the file since is not noticed here.
std::unique_ptr<BlobArchive> open_archive(const std::filesystem::path& file, Archived what,
                                          std::string_view checksum);

}  // namespace docent::sqlite
