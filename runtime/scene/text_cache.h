#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/scene/view.h"

namespace docent {

/// A text in texture memory.
struct TextPiece {
  TextureId texture = TextureId::None;
  float width = 0, height = 0;  ///< Pixels.
  std::uint32_t lines = 0;
  bool cut = false;
};

/// Sets each text once and remembers in which texture it is. Lives on the worker; what changes in
/// texture memory is carried to the frame thread as TextChanges.
class TextCache {
 public:
  /// Hands out textures from `first` upwards, the lowest free one first. Texts unused for the
  /// `kept_views` views last made are retired once all texts together exceed `budget` bytes.
  TextCache(SetText set, std::uint32_t first, std::size_t budget);

  TextPiece piece(const TextStyle& style, std::string_view text, std::uint32_t width);

  /// Ends a view: what changed since the last one, or nothing.
  std::unique_ptr<TextChanges> end_view();

 private:
  struct Entry {
    TextPiece piece;
    std::size_t bytes = 0;
    std::uint64_t used = 0;  ///< The view that last used it.
  };
  void retire_unused();
  TextureId free_texture();

  /// The last two views may still be fading on the screen; two more make going back quick.
  static constexpr std::uint64_t kept_views = 4;

  SetText set_;
  std::uint32_t first_, count_ = 0;
  std::size_t budget_, bytes_ = 0;
  std::uint64_t view_ = 0;
  std::map<std::string, Entry, std::less<>> entries_;
  std::vector<TextureId> free_;  ///< Descending.
  TextChanges changes_;
};

}  // namespace docent
