#include "runtime/scene/text_cache.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace docent {
namespace {

std::string key_of(const TextStyle& s, std::string_view text, std::uint32_t width) {
  return fmt::format("{}|{}|{}|{}|{}|{}{}|{}|{}|{}", static_cast<int>(s.family), s.weight, s.size,
                     s.line_height, s.max_lines, s.right_to_left ? 'r' : 'l', s.tabular ? 't' : 'p',
                     s.language, width, text);
}

}  // namespace

TextCache::TextCache(SetText set, std::uint32_t first, std::size_t budget)
    : set_(std::move(set)), first_(first), budget_(budget) {}

TextPiece TextCache::piece(const TextStyle& style, std::string_view text, std::uint32_t width) {
  std::string key = key_of(style, text, width);
  if (const auto known = entries_.find(key); known != entries_.end()) {
    known->second.used = view_;
    return known->second.piece;
  }
  TextBitmap bitmap = set_(style, text, width);
  if (bitmap.coverage.empty()) return {};
  const TextPiece piece{free_texture(), static_cast<float>(bitmap.width),
                        static_cast<float>(bitmap.height), bitmap.lines, bitmap.cut};
  bytes_ += bitmap.coverage.size();
  entries_.emplace(std::move(key), Entry{piece, bitmap.coverage.size(), view_});
  changes_.uploads.push_back({piece.texture, std::move(bitmap)});
  return piece;
}

TextureId TextCache::free_texture() {
  if (free_.empty()) return static_cast<TextureId>(first_ + count_++);
  const TextureId texture = free_.back();
  free_.pop_back();
  return texture;
}

void TextCache::retire_unused() {
  if (bytes_ <= budget_) return;
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    if (entry->second.used + kept_views > view_) {
      ++entry;
      continue;
    }
    bytes_ -= entry->second.bytes;
    changes_.retired.push_back(entry->second.piece.texture);
    entry = entries_.erase(entry);
  }
}

std::unique_ptr<TextChanges> TextCache::end_view() {
  ++view_;
  const std::size_t before = changes_.retired.size();
  retire_unused();
  // Free again only from the next view on: these changes must reach texture memory first.
  free_.insert(free_.end(), changes_.retired.begin() + static_cast<std::ptrdiff_t>(before),
               changes_.retired.end());
  std::ranges::sort(free_, std::greater<>{});
  if (changes_.uploads.empty() && changes_.retired.empty()) return nullptr;
  return std::make_unique<TextChanges>(std::exchange(changes_, {}));
}

}  // namespace docent
