#include <zip.h>

#include <memory>

#include "content/content_error.h"
#include "content/import/imdf/imdf.h"

namespace docent::import {
namespace {

struct DiscardArchive {
  void operator()(zip_t* archive) const noexcept { zip_discard(archive); }
};
struct CloseFile {
  void operator()(zip_file_t* file) const noexcept { zip_fclose(file); }
};

constexpr std::uint64_t largest_archive = 256ULL << 20;
constexpr zip_int64_t most_files = 1000;

[[noreturn]] void fail_archive(const std::string& file, const std::string& message) {
  throw content::ContentError(file, 0, 0, "invalid-archive", message,
                              "export or download the archive again");
}

std::string read_member(const std::string& file, zip_t* archive, zip_uint64_t index,
                        std::uint64_t size) {
  const std::unique_ptr<zip_file_t, CloseFile> member(zip_fopen_index(archive, index, 0));
  if (!member) fail_archive(file, "a file in the archive cannot be unpacked: is it encrypted?");
  std::string text(size, '\0');
  const zip_int64_t read = zip_fread(member.get(), text.data(), size);
  if (read < 0 || static_cast<std::uint64_t>(read) != size)
    fail_archive(file, "a file in the archive is damaged or cut short");
  return text;
}

}  // namespace

std::map<std::string, std::string> unpack_archive(const std::string& file, std::string_view bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* opened = source == nullptr ? nullptr : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (opened == nullptr && source != nullptr) zip_source_free(source);
  zip_error_fini(&error);
  const std::unique_ptr<zip_t, DiscardArchive> archive(opened);
  if (!archive) fail_archive(file, "this ZIP archive is damaged or cut short");
  std::map<std::string, std::string> files;
  std::uint64_t total = 0;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  if (count > most_files) fail_archive(file, "the archive holds more than 1000 files");
  for (zip_int64_t i = 0; i < count; ++i) {
    zip_stat_t stat;
    zip_stat_init(&stat);
    const auto index = static_cast<zip_uint64_t>(i);
    if (zip_stat_index(archive.get(), index, 0, &stat) != 0 || stat.name == nullptr) continue;
    std::string name(stat.name);
    if (name.ends_with('/') || name.starts_with("__MACOSX")) continue;
    name = name.substr(name.rfind('/') + 1);
    if (!name.ends_with(".geojson") && !name.ends_with(".json") && !name.ends_with(".ifc") &&
        !name.ends_with(".IFC"))
      continue;
    total += stat.size;
    if (total > largest_archive) fail_archive(file, "the archive would unpack to more than 256 MB");
    files[name] = read_member(file, archive.get(), index, stat.size);
  }
  return files;
}

bool is_imdf(std::string_view bytes) {
  // Names of members are in the clear: in front of each, and again at the end.
  return bytes.starts_with("PK") && bytes.find("unit.geojson") != std::string_view::npos &&
         bytes.find("level.geojson") != std::string_view::npos;
}

}  // namespace docent::import
