#pragma once

namespace docent {

/// Owns a C handle; the closing function is part of the type, so nothing can forget it:
/// `std::unique_ptr<sqlite3, CloseWith<sqlite3_close_v2>>`.
template <auto close>
struct CloseWith {
  void operator()(auto* handle) const noexcept { close(handle); }
};

}  // namespace docent
