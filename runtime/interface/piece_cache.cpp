#include "runtime/interface/piece_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace docent::interface {
namespace {

std::string key_of(const TextStyle& s, std::string_view text, std::uint32_t width) {
  return fmt::format("text|{}|{}|{}|{}|{},{},{}|{}{}|{}|{}|{}", static_cast<int>(s.family),
                     s.weight, s.size, s.line_height, s.max_lines, s.first_line, s.line_count,
                     s.centred         ? 'c'
                     : s.right_to_left ? 'r'
                                       : 'l',
                     s.tabular ? 't' : 'p', s.language, width, text);
}

std::string key_of(std::uint32_t image, std::uint32_t width, std::uint32_t height,
                   std::uint32_t apart) {
  return fmt::format("picture|{}|{}|{}|{}", image, width, height, apart);
}

/// What a piece takes in texture memory: rows of whole cache lines, and the texture that has them.
/// Mesa 22.3's software renderer takes 3.4 KB for the 1,000 bytes of a short line of letters.
std::size_t texture_bytes(std::size_t width, std::size_t height, std::size_t texel) {
  constexpr std::size_t cache_line = 64, texture = 2048;
  return texture + (width * texel + cache_line - 1) / cache_line * cache_line * height;
}

}  // namespace

PieceCache::PieceCache(PieceMakers makers, std::uint32_t first, std::size_t budget)
    : makers_(std::move(makers)), first_(first), budget_(budget) {}

const TextPiece* PieceCache::find(std::string_view key) {
  const auto known = entries_.find(key);
  if (known == entries_.end()) return nullptr;
  known->second.used = view_;
  return &known->second.piece;
}

/// The last `letters` bytes of the key are what the piece says.
TextPiece PieceCache::keep(std::string key, const TextPiece& piece, PieceUpload upload,
                           std::size_t letters) {
  const auto& [texture, text, picture] = upload;
  const std::size_t bytes = picture.rgba.empty() ? texture_bytes(text.width, text.height, 1)
                                                 : texture_bytes(picture.width, picture.height, 4);
  bytes_ += bytes;
  const auto kept = entries_.emplace(std::move(key), Entry{piece, bytes, view_, {}}).first;
  TextPiece& whole = kept->second.piece;
  whole.words = std::string_view(kept->first).substr(kept->first.size() - letters);
  changes_.uploads.push_back(std::move(upload));
  return whole;
}

TextPiece PieceCache::text(const TextStyle& style, std::string_view text, std::uint32_t width) {
  std::string key = key_of(style, text, width);
  if (const TextPiece* known = find(key)) return *known;
  TextBitmap bitmap = makers_.set_text(style, text, width);
  if (bitmap.coverage.empty()) return {};
  const TextPiece piece{.texture = free_texture(),
                        .width = static_cast<float>(bitmap.width),
                        .height = static_cast<float>(bitmap.height),
                        .lines = bitmap.lines,
                        .cut = bitmap.cut,
                        .size = style.size,
                        .words = {}};
  return keep(std::move(key), piece,
              {.texture = piece.texture, .text = std::move(bitmap), .picture = {}}, text.size());
}

TextPiece PieceCache::extent(const TextStyle& style, std::string_view text, std::uint32_t width) {
  std::string key = key_of(style, text, width);
  if (const TextPiece* known = find(key)) {
    TextPiece piece = *known;
    piece.texture = scene::TextureId::None;
    return piece;
  }
  if (const auto known = extents_.find(key); known != extents_.end()) return known->second;
  if (extents_.size() == most_extents) extents_.clear();
  const TextBitmap bitmap = makers_.set_text(style, text, width);
  const TextPiece piece{.width = static_cast<float>(bitmap.width),
                        .height = static_cast<float>(bitmap.height),
                        .lines = bitmap.lines,
                        .cut = bitmap.cut,
                        .size = style.size,
                        .words = {}};
  return extents_.emplace(std::move(key), piece).first->second;
}

TextPiece PieceCache::pictogram(Pictogram what, std::uint32_t side) {
  std::string key = fmt::format("pictogram|{}|{}", static_cast<int>(what), side);
  if (const TextPiece* known = find(key)) return *known;
  TextBitmap bitmap = draw_pictogram(what, side);
  const TextPiece piece{.texture = free_texture(),
                        .width = static_cast<float>(bitmap.width),
                        .height = static_cast<float>(bitmap.height),
                        .lines = bitmap.lines,
                        .words = {}};
  keep(std::move(key), piece, {.texture = piece.texture, .text = std::move(bitmap), .picture = {}});
  return piece;
}

scene::TextureId PieceCache::picture(std::uint32_t image, std::uint32_t width, std::uint32_t height,
                                     std::uint32_t apart) {
  std::string key = key_of(image, width, height, apart);
  if (const TextPiece* known = find(key)) return known->texture;
  if (!makers_.set_picture) return scene::TextureId::None;
  Pixels pixels = makers_.set_picture(image, width, height);
  if (pixels.rgba.empty()) return scene::TextureId::None;
  const scene::TextureId texture = free_texture();
  keep(std::move(key), {.texture = texture},
       {.texture = texture, .text = {}, .picture = std::move(pixels)});
  return texture;
}

scene::TextureId PieceCache::drawing(std::string key, const std::function<Pixels()>& draw) {
  key.insert(0, "drawing|");
  if (const TextPiece* known = find(key)) return known->texture;
  Pixels pixels = draw();
  const scene::TextureId texture = free_texture();
  keep(std::move(key), {.texture = texture},
       {.texture = texture, .text = {}, .picture = std::move(pixels)});
  return texture;
}

void PieceCache::rest() const {
  if (makers_.rest) makers_.rest();
}

scene::TextureId PieceCache::free_texture() {
  if (free_.empty()) return static_cast<scene::TextureId>(first_ + count_++);
  const scene::TextureId texture = free_.back();
  free_.pop_back();
  return texture;
}

void PieceCache::note_what_shows(std::uint32_t part) {
  const auto bit = static_cast<std::uint16_t>(1U << part % most_parts);
  const auto rest = static_cast<std::uint16_t>(~bit);
  for (auto& [key, entry] : entries_) {
    auto& shown = entry.shown_by;
    for (std::size_t i = shown.size(); --i > 0;)
      shown[i] = static_cast<std::uint16_t>((shown[i] & rest) | (shown[i - 1] & bit));
    shown[0] = static_cast<std::uint16_t>((shown[0] & rest) | (entry.used == view_ ? bit : 0));
  }
}

bool PieceCache::may_go(const Entry& entry) const {
  return entry.used + kept_views <= view_ &&
         std::ranges::all_of(entry.shown_by, [](std::uint16_t parts) { return parts == 0; });
}

void PieceCache::retire_unused() {
  if (bytes_ <= budget_) return;
  std::vector<decltype(entries_)::iterator> unused;
  for (auto entry = entries_.begin(); entry != entries_.end(); ++entry)
    if (may_go(entry->second)) unused.push_back(entry);
  std::ranges::stable_sort(unused, {}, [](const auto& entry) { return entry->second.used; });
  for (const auto& entry : unused) {
    if (bytes_ <= budget_) return;
    bytes_ -= entry->second.bytes;
    changes_.retired.push_back(entry->second.piece.texture);
    entries_.erase(entry);
  }
}

std::unique_ptr<PieceChanges> PieceCache::end_view(std::uint32_t part) {
  note_what_shows(part);
  ++view_;
  const std::size_t before = changes_.retired.size();
  retire_unused();
  // Free again only from the next view on: these changes must reach texture memory first.
  free_.insert(free_.end(), changes_.retired.begin() + static_cast<std::ptrdiff_t>(before),
               changes_.retired.end());
  std::ranges::sort(free_, std::greater<>{});
  if (changes_.uploads.empty() && changes_.retired.empty()) return nullptr;
  return std::make_unique<PieceChanges>(std::exchange(changes_, {}));
}

}  // namespace docent::interface
