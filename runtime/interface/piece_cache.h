#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/pictogram.h"
#include "runtime/interface/picture.h"
#include "runtime/interface/text.h"
#include "runtime/interface/view.h"

namespace docent::interface {

/// A text in texture memory.
struct TextPiece {
  scene::TextureId texture = scene::TextureId::None;
  float width = 0, height = 0;  ///< Pixels.
  std::uint32_t lines = 0;
  bool cut = false;          ///< It ended in an ellipsis.
  float size = 0;            ///< Pixels: of its letters. 0: a pictogram.
  std::string_view words{};  ///< What it says; until the view is ended.
};

/// Who makes the pieces of a view. A view without pictures is made by leaving `set_picture` empty.
struct PieceMakers {
  SetText set_text;
  SetPicture set_picture;
  std::function<void()> rest{};  ///< Called when a visitor has left or reads another language,
                                 ///< to tidy up; may be empty.
};

/// Makes each text and each picture of the views once, in the size in which it is drawn, and
/// remembers in which texture it is: so texture memory depends on what views show and not on how
/// much a museum owns. Lives on the worker; what changes in texture memory is carried to the frame
/// thread as PieceChanges.
class PieceCache {
 public:
  /// Hands out textures from `first` upwards, the lowest free one first. While all pieces together
  /// exceed `budget` bytes of texture memory, the one is retired that was used longest ago, of
  /// those that are neither in the `kept_views` views made last nor in the last few of any part of
  /// the glass. There are at most `most_parts` parts.
  PieceCache(PieceMakers makers, std::uint32_t first, std::size_t budget);

  TextPiece text(const TextStyle& style, std::string_view text, std::uint32_t width);
  /// How large that piece is, without one: its texture is None.
  TextPiece extent(const TextStyle& style, std::string_view text, std::uint32_t width);
  /// A picture that is drawn where it is not there yet; `key` says what is on it, and how large.
  scene::TextureId drawing(std::string key, const std::function<Pixels()>& draw);
  TextPiece pictogram(Pictogram what, std::uint32_t side);
  /// Nobody waits for a piece now: the makers may tidy up.
  void rest() const;
  /// An image of the museum, `width` by `height` pixels, as SetPicture makes it. What is played in
  /// one part of the glass is not what another part sees: `apart` tells their textures apart.
  scene::TextureId picture(std::uint32_t image, std::uint32_t width, std::uint32_t height,
                           std::uint32_t apart = 0);

  /// Ends a view of a part of the glass. Returns what changed since the last view; null: nothing.
  std::unique_ptr<PieceChanges> end_view(std::uint32_t part = 0);

  static constexpr std::uint32_t most_parts = 16;

 private:
  struct Entry {
    TextPiece piece;
    std::size_t bytes = 0;   ///< Of texture memory.
    std::uint64_t used = 0;  ///< The view that last used it.
    /// A bit for each part of the glass that shows it: in the part's last view, in the one before,
    /// and so on. One of these views is on the screen, one may still be fading, and some were out
    /// of date before they were shown.
    std::array<std::uint16_t, 4> shown_by{};
  };
  const TextPiece* find(std::string_view key);
  TextPiece keep(std::string key, const TextPiece& piece, PieceUpload upload,
                 std::size_t letters = 0);
  void note_what_shows(std::uint32_t part);
  bool may_go(const Entry& entry) const;
  void retire_unused();
  scene::TextureId free_texture();

  /// Going back to one of these is quick.
  static constexpr std::uint64_t kept_views = 4;
  static constexpr std::size_t most_extents = 2000;

  PieceMakers makers_;
  std::uint32_t first_, count_ = 0;
  std::size_t budget_, bytes_ = 0;
  std::uint64_t view_ = 0;
  std::map<std::string, Entry, std::less<>> entries_;
  std::map<std::string, TextPiece, std::less<>> extents_;  ///< Of at most `most_extents` texts.
  std::vector<scene::TextureId> free_;                     ///< Descending.
  PieceChanges changes_;
};

}  // namespace docent::interface
