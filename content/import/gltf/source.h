#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "content/import/gltf/container.h"
#include "content/import/gltf/part.h"
#include "content/import/gltf/read_model.h"

namespace docent::import::gltf {

/// What a model may hold at most, in all: more is refused before its memory is taken.
inline constexpr std::size_t most_vertices = 4'000'000, most_corners = 12'000'000;
inline constexpr std::size_t most_nodes = 20'000;

/// A file while it is read: its JSON, and the bytes that its buffers and views hold. Each is
/// fetched when first asked for, and once.
class Source {
 public:
  Source(std::string_view bytes, const std::string& file, const ReadBeside& beside);

  Part root() const { return {file_, &container_.json, ""}; }
  const std::string& file() const noexcept { return file_; }

  struct View {
    std::string_view bytes;
    std::size_t stride = 0;  ///< 0: its elements lie close.
  };
  View view(std::uint64_t index);
  /// Bytes that a "uri" holds or names; empty where no such file is there.
  std::optional<std::string> bytes_of_uri(const Part& uri);

  /// Counts what is about to be read; a ContentError about the part once it is too much.
  void count_vertices(std::size_t more, const Part& part);
  void count_corners(std::size_t more, const Part& part);
  void warn(std::string sentence);
  std::vector<std::string> warnings;

 private:
  std::string_view buffer(std::uint64_t index, const Part& asked_by);
  std::string_view unpacked(const Part& view, const Part& packed, std::uint64_t index,
                            std::uint64_t length);

  std::string file_;
  Container container_;
  const ReadBeside& beside_;
  std::map<std::uint64_t, std::string> buffers_, unpacked_;
  std::size_t vertices_ = 0, corners_ = 0, unpacked_bytes_ = 0;
};

}  // namespace docent::import::gltf
