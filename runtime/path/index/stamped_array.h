#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace docent::path {

/// What a search notes about the things it meets. All notes are forgotten at once, at a cost that
/// does not depend on their number, so a search over a large floor pays only for what it visits.
template <class Note>
class StampedArray {
 public:
  /// Forgets everything; afterwards things from 0 to count - 1 may be noted.
  void forget(std::size_t count) {
    if (stamp_.size() < count) {
      stamp_.resize(count, 0);
      note_.resize(count);
    }
    if (++now_ != 0) return;
    stamp_.assign(stamp_.size(), 0);  // After 2^32 searches the stamps would repeat.
    now_ = 1;
  }
  bool has(std::size_t i) const noexcept { return stamp_[i] == now_; }
  /// The note about a thing; a fresh one where there was none.
  Note& operator[](std::size_t i) noexcept {
    if (stamp_[i] != now_) {
      stamp_[i] = now_;
      note_[i] = Note{};
    }
    return note_[i];
  }

 private:
  std::uint32_t now_ = 0;
  std::vector<std::uint32_t> stamp_;
  std::vector<Note> note_;
};

}  // namespace docent::path
