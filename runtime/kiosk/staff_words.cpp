#include "runtime/kiosk/staff_words.h"

#include <algorithm>

#include "runtime/interface/phrases.h"

namespace docent::kiosk {
namespace {

struct Entry {
  std::string_view key;
  std::string_view english;
};

/// By StaffWord. The English is that of config/words/en.toml, for museums that were compiled
/// before there were such words.
constexpr std::array<Entry, staff_words_count> entries{{
    {"staff_title", "For staff"},
    {"staff_delete", "Delete"},
    {"staff_enter", "Enter"},
    {"staff_close", "Back to the visitors"},
    {"staff_back", "Back"},
    {"staff_wrong", "That was not it. Again in {n} s"},
    {"staff_wait", "Please wait {n} s and try again"},
    {"staff_calibrate", "Calibrate the glass"},
    {"staff_diagnose", "What is running here"},
    {"staff_exit", "End, and use the keyboard"},
    {"staff_mark", "Touch the middle of the mark"},
    {"staff_felt", "Touch anywhere: a ring shows where it is felt"},
    {"staff_far", "The touches were too far from the marks: nothing has been changed"},
    {"staff_confirm", "Is the glass right now?"},
    {"staff_keep", "Keep it"},
    {"staff_moved", "Moved by {n} %. Untouched for {seconds} s, the old one returns"},
    {"staff_kept", "The calibration is kept"},
    {"staff_kept_for_now", "Kept until docent ends: it has no folder to keep it in"},
    {"staff_old_back", "The old calibration is back"},
    {"staff_version", "Version"},
    {"staff_shows", "Shows"},
    {"staff_shows_what", "{title}; floors: {floors}, exhibits: {exhibits}, languages: {languages}"},
    {"staff_database", "Database"},
    {"staff_screen", "Screen"},
    {"staff_frames", "Frames"},
    {"staff_frames_made", "{made} made, {late} late"},
    {"staff_frame_time", "A frame takes"},
    {"staff_frame_takes", "{n} ms, {most} ms at most, and {drawing} ms of drawing"},
    {"staff_touches", "Touches"},
    {"staff_since_start", "{n} since it began"},
    {"staff_touch_screen", "Touch screen"},
    {"staff_keypad", "Keypad"},
    {"staff_ignored", "Ignored"},
    {"staff_devices", "Devices"},
    {"staff_no_devices", "neither a touch screen nor a keypad"},
}};

bool is_known(const Language& language, StaffWord word) {
  return language.words.contains(key_of(word));
}

/// Empty: none of the museum's languages.
const Language* language_for_staff(const Museum& museum, std::uint32_t wanted) {
  for (const std::uint32_t candidate : {wanted, 0U})
    if (candidate < museum.languages.size() &&
        is_known(museum.languages[candidate], StaffWord::Title))
      return &museum.languages[candidate];
  return nullptr;
}

}  // namespace

std::string_view key_of(StaffWord word) noexcept {
  return entries[static_cast<std::size_t>(word)].key;
}

StaffWords staff_words(const Museum& museum, std::uint32_t language) {
  StaffWords words;
  words.page_of = "{n} of {total}";
  for (std::size_t i = 0; i < entries.size(); ++i) words.words[i] = entries[i].english;
  for (std::size_t i = 0; i < words.digits.size(); ++i) words.digits[i] = std::to_string(i);
  const Language* const spoken = language_for_staff(museum, language);
  if (spoken == nullptr) return words;
  words.language = spoken->tag;
  words.right_to_left = spoken->right_to_left;
  const auto take = [&](std::string_view key, std::string& into) {
    if (const auto found = spoken->words.find(key); found != spoken->words.end())
      into = found->second;
  };
  for (std::size_t i = 0; i < entries.size(); ++i) take(entries[i].key, words.words[i]);
  take("page_of", words.page_of);
  const auto number = static_cast<std::uint32_t>(spoken - museum.languages.data());
  for (std::size_t i = 0; i < words.digits.size(); ++i)
    words.digits[i] = interface::number_in(museum, number, static_cast<long>(i));
  return words;
}

std::string StaffWords::in_digits(std::string_view text) const {
  std::string out;
  for (const char c : text)
    if (c >= '0' && c <= '9')
      out += digits[static_cast<std::size_t>(c - '0')];
    else
      out += c;
  return out;
}

std::string StaffWords::filled(
    StaffWord word, std::initializer_list<std::pair<std::string_view, std::string>> values) const {
  std::string out((*this)[word]);
  for (const auto& [name, value] : values) out = interface::filled_in(out, name, in_digits(value));
  return out;
}

std::string StaffWords::one_of(std::size_t number, std::size_t total) const {
  return interface::filled_in(interface::filled_in(page_of, "n", in_digits(std::to_string(number))),
                              "total", in_digits(std::to_string(total)));
}

}  // namespace docent::kiosk
