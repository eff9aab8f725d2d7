#include "runtime/release/device_state.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace docent::release {
namespace {

using Words = std::vector<std::string_view>;

constexpr std::string_view state_head = "docent update state 1\n";
constexpr Time soon = 600;
constexpr std::size_t too_often = 3;

bool read_line(const Words& words, DeviceState& state) {
  const std::string_view fact = words[0];
  if (fact == "kept") {
    if (words.size() != 4) return false;
    const auto version = number_of(words[1]), schema = number_of(words[2]);
    if (!version || !schema || *schema > 0xffffffff) return false;
    state.kept.push_back({*version, static_cast<std::uint32_t>(*schema), std::string(words[3])});
    return true;
  }
  if (words.size() != 2) return false;
  const std::string_view value = words[1];
  if (fact == "etag") {
    state.etag = value;
    return true;
  }
  if (fact == "portion") {
    const auto [end, error] =
        std::from_chars(value.data(), value.data() + value.size(), state.portion);
    return error == std::errc{} && end == value.data() + value.size() && state.portion >= 0 &&
           state.portion < 1;
  }
  if (fact == "start" || fact == "shown_since" || fact == "seen_issued") {
    const auto time = time_of(value);
    if (!time) return false;
    if (fact == "start")
      state.starts.push_back(*time);
    else
      (fact == "shown_since" ? state.shown_since : state.seen_issued) = *time;
    return true;
  }
  const auto number = number_of(value);
  if (!number) return false;
  if (fact == "seen") return state.seen = *number, true;
  if (fact == "shown") return state.shown = *number, true;
  if (fact == "shown_schema")
    return state.shown_schema = static_cast<std::uint32_t>(*number), *number <= 0xffffffff;
  if (fact == "pending") return state.is_pending = *number != 0, true;
  if (fact == "refused") return state.refused.push_back(*number), true;
  return false;
}

const Kept* newest(const DeviceState& state, std::uint32_t schema, auto&& may_be) {
  const Kept* found = nullptr;
  for (const Kept& kept : state.kept)
    if (kept.schema == schema && may_be(kept) &&
        std::ranges::find(state.refused, kept.version) == state.refused.end() &&
        (found == nullptr || kept.version > found->version))
      found = &kept;
  return found;
}

}  // namespace

std::string to_text(const DeviceState& state) {
  std::string text(state_head);
  text += fmt::format("portion {}\nseen {}\nseen_issued {}\n", state.portion, state.seen,
                      text_of(state.seen_issued));
  text += fmt::format("shown {}\nshown_schema {}\nshown_since {}\npending {}\n", state.shown,
                      state.shown_schema, text_of(state.shown_since), state.is_pending ? 1 : 0);
  for (const Time start : state.starts) text += fmt::format("start {}\n", text_of(start));
  for (const std::uint64_t version : state.refused) text += fmt::format("refused {}\n", version);
  for (const Kept& kept : state.kept)
    text += fmt::format("kept {} {} {}\n", kept.version, kept.schema, kept.hash);
  if (!state.etag.empty()) text += fmt::format("etag {}\n", state.etag);
  return text;
}

Result<DeviceState> parse_state(std::string_view text, const std::filesystem::path& file) {
  DeviceState state;
  bool sound = text.starts_with(state_head);
  if (sound)
    for (const Words& words : lines_of(text.substr(state_head.size())))
      sound = sound && read_line(words, state);
  if (!sound)
    return std::unexpected(
        Error{Errc::Damaged, fmt::format("{}: is damaged; remove it, and the next release is taken "
                                         "as on a new device",
                                         file.string())});
  return state;
}

bool note_start(DeviceState& state, Time now) {
  const bool is_soon = now >= state.shown_since && now - state.shown_since <= soon;
  if (state.shown == 0 || !is_soon) return false;
  state.starts.push_back(now);
  return state.starts.size() >= too_often;
}

const Kept* one_before(const DeviceState& state, std::uint32_t schema) {
  return newest(state, schema, [&](const Kept& kept) { return kept.version < state.shown; });
}

const Kept* newest_kept(const DeviceState& state, std::uint32_t schema) {
  return newest(state, schema, [](const Kept&) { return true; });
}

}  // namespace docent::release
