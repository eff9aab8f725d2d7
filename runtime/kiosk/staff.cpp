#include "runtime/kiosk/staff.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <string_view>
#include <utility>

#include "platform/file/read_file.h"
#include "platform/gles/textures.h"
#include "platform/pin/pin.h"
#include "runtime/kiosk/options.h"
#include "runtime/kiosk/statistics.h"
#include "runtime/model/last_catch.h"

namespace docent::kiosk {
namespace {

constexpr double pad_seconds = 30;  // without a touch, until the visitors have the glass again
constexpr double pages_seconds = 120;
constexpr double confirm_seconds = 15;
/// The last that the renderer keeps: far above the building's pictures and the planner's pieces.
constexpr std::uint32_t first_texture = gles::Textures::most - 2 * most_staff_texts;
constexpr std::string_view calibration_file = "glass.calibration";

std::string whole_seconds(double seconds) {
  return fmt::format("{:.0f}", std::ceil(seconds));
}

bool is_ready(const auto& future) {
  return future.valid() && future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

std::filesystem::path staff_folder() {
  const char* const folders = std::getenv("STATE_DIRECTORY");
  if (folders == nullptr) return {};
  // Where a unit has several, ours bears the glass in its name.
  std::string_view rest(folders);
  const std::string_view first = rest.substr(0, rest.find(':'));
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(':'));
    if (one.ends_with("glass")) return one;
    rest.remove_prefix(std::min(rest.size(), one.size() + 1));
  }
  return first;
}

input::Calibration load_calibration(const std::filesystem::path& folder) {
  if (folder.empty() || !file::is_there(folder / calibration_file)) return {};
  const std::filesystem::path path = folder / calibration_file;
  const Result<std::string> text = file::read_file(path);
  const auto found = text ? input::parse_calibration(*text, path.string())
                          : Result<input::Calibration>(std::unexpected(text.error()));
  if (found) return *found;
  say(found.error());
  return {};
}

Staff::Staff(StaffSettings settings, Words words, Look look, Facts facts, Facts slow_facts)
    : settings_(std::move(settings)),
      words_in_use_(std::move(words)),
      look_(std::move(look)),
      facts_(std::move(facts)),
      slow_facts_(std::move(slow_facts)),
      lock_(settings_.pin),
      calibration_(load_calibration(settings_.folder)) {
  fingers_.reserve(most_fingers);
  touched_.reserve(input::calibration_marks.size());
}

Staff::~Staff() = default;

input::InputEvent Staff::corrected(input::InputEvent event) const noexcept {
  event.contact = input::calibrated(calibration_, event.contact);
  return event;
}

Staff::Finger* Staff::finger(std::uint32_t id) noexcept {
  const auto at = std::ranges::find(fingers_, id, [](const Finger& f) { return f.at.id; });
  return at == fingers_.end() ? nullptr : &*at;
}

int Staff::button_at(float x, float y) const noexcept {
  if (!page_ || page_->screen != open_) return -1;
  for (std::size_t i = 0; i < page_->buttons.size(); ++i)
    if (scene::contains(page_->buttons[i].rect, x, y)) return static_cast<int>(i);
  return -1;
}

bool Staff::take(const input::InputEvent& event, double time) {
  using Kind = input::InputEvent::Kind;
  if (!lock_.has_pin()) return false;
  const input::Contact at = corrected(event).contact;
  input::InputEvent meant = event;
  meant.contact = at;
  gesture_.take(meant, time);
  switch (event.kind) {
    case Kind::KeyDown:
      if (!is_open()) return false;
      last_event_ = time;
      press_key(event, time);
      return true;
    case Kind::KeyUp:
      return is_open();
    case Kind::Down:
      if (!is_open()) return false;
      last_event_ = time;
      if (fingers_.size() < most_fingers)
        fingers_.push_back({event.contact, at, button_at(at.x, at.y)});
      focus_ = -1;
      return true;
    case Kind::Move:
      if (Finger* const known = finger(event.contact.id)) {
        known->raw = event.contact;
        known->at = at;
        return true;
      }
      return false;
    case Kind::Up:
    case Kind::Cancel:
      break;
  }
  Finger* const known = finger(event.contact.id);
  if (known == nullptr) return false;
  const Finger left = *known;
  fingers_.erase(fingers_.begin() + (known - fingers_.data()));
  if (!is_open() || event.kind == Kind::Cancel) return true;
  last_event_ = time;
  if (open_ == StaffScreen::Calibrate)
    touch_mark(left.raw, time);
  else if (left.button >= 0 && left.button == button_at(left.at.x, left.at.y))
    press(page_->buttons[static_cast<std::size_t>(left.button)].action, time);
  return true;
}

void Staff::press_key(const input::InputEvent& event, double time) {
  // That a calibration is right only a touch can prove.
  if (open_ == StaffScreen::Confirm || open_ == StaffScreen::Calibrate) {
    if (event.key == input::Key::Back) press(StaffAction::Close, time);
    return;
  }
  if (open_ == StaffScreen::Pad && event.key == input::Key::Character && event.character >= '0' &&
      event.character <= '9')
    return press(static_cast<StaffAction>(event.character - '0'), time);
  const int count = page_ ? static_cast<int>(page_->buttons.size()) : 0;
  switch (event.key) {
    case input::Key::Up:
    case input::Key::Left:
      focus_ = count > 0 ? (std::max(focus_, 0) + count - 1) % count : -1;
      return;
    case input::Key::Down:
    case input::Key::Right:
      focus_ = count > 0 ? (focus_ + 1) % count : -1;
      return;
    case input::Key::Back:
      return press(
          open_ == StaffScreen::Pad && !typed_.empty() ? StaffAction::Delete : StaffAction::Close,
          time);
    case input::Key::Enter:
      if (focus_ >= 0 && focus_ < count)
        return press(page_->buttons[static_cast<std::size_t>(focus_)].action, time);
      if (open_ == StaffScreen::Pad) press(StaffAction::Enter, time);
      return;
    default:
      return;
  }
}

void Staff::press(StaffAction action, double time) {
  switch (action) {
    case StaffAction::Delete:
      if (!typed_.empty()) typed_.pop_back();
      return;
    case StaffAction::Enter:
      if (const double pause = lock_.pause_left(time); pause > 0)
        open(StaffScreen::Pad, words_.filled(StaffWord::Wait, {{"n", whole_seconds(pause)}}));
      else
        lock_.try_pin(typed_, time);
      typed_.clear();
      return;
    case StaffAction::Close:
      return close();
    case StaffAction::Calibrate:
      touched_.clear();
      return open(StaffScreen::Calibrate, words_.one_of(1, input::calibration_marks.size()));
    case StaffAction::Diagnose:
      return open(StaffScreen::Diagnose, std::string(words_[StaffWord::Felt]));
    case StaffAction::Exit:
      exit_ = true;
      return close();
    case StaffAction::Keep:
      keep_calibration();
      return;
    case StaffAction::Menu:
      return open(StaffScreen::Menu);
    default:
      if (action <= StaffAction::Figure9 && typed_.size() < pin::most_figures)
        typed_.push_back(static_cast<char>('0' + static_cast<int>(action)));
  }
}

void Staff::touch_mark(const input::Contact& raw, double time) {
  const auto& [x, y] = input::calibration_marks[touched_.size()];
  touched_.push_back({x, y, raw.x, raw.y});
  if (touched_.size() == input::calibration_marks.size()) return calibrate_from(time);
  open(StaffScreen::Calibrate, words_.one_of(touched_.size() + 1, input::calibration_marks.size()));
}

void Staff::calibrate_from(double time) {
  const auto found = input::fit(touched_);
  touched_.clear();
  if (!found) return open(StaffScreen::Menu, std::string(words_[StaffWord::Far]));
  calibration_before_ = std::exchange(calibration_, *found);
  confirm_until_ = time + confirm_seconds;
  const double off = std::hypot((found->a + found->b) / 2 + found->c - 0.5,
                                (found->d + found->e) / 2 + found->f - 0.5);
  open(StaffScreen::Confirm,
       words_.filled(StaffWord::Moved, {{"n", fmt::format("{:.1f}", 100 * off)},
                                        {"seconds", whole_seconds(confirm_seconds)}}));
}

void Staff::keep_calibration() {
  calibration_before_ = calibration_;
  if (settings_.folder.empty())
    return open(StaffScreen::Menu, std::string(words_[StaffWord::KeptForNow]));
  saving_ = std::async(std::launch::async, [folder = settings_.folder, kept = calibration_] {
    if (const auto saved = write_whole(folder / calibration_file, input::to_text(kept)); !saved)
      say(saved.error());
  });
  open(StaffScreen::Menu, std::string(words_[StaffWord::Kept]));
}

void Staff::open(StaffScreen screen, std::string message) {
  open_ = screen;
  message_ = std::move(message);
  page_wanted_ = true;
  focus_ = -1;
}

void Staff::close() noexcept {
  if (open_ == StaffScreen::Confirm) calibration_ = calibration_before_;
  open_.reset();
  typed_.clear();
}

void Staff::take_lock_answer(double time) {
  if (settings_.repeats_exactly) lock_.wait();
  const std::optional<bool> right = lock_.answer(time);
  if (!right || open_ != StaffScreen::Pad) return;
  if (*right) return open(StaffScreen::Menu);
  open(StaffScreen::Pad,
       words_.filled(StaffWord::Wrong, {{"n", whole_seconds(lock_.pause_left(time))}}));
}

void Staff::close_in_time(double time) {
  if (!is_open()) return;
  if (open_ == StaffScreen::Confirm) {
    if (time < confirm_until_) return;
    calibration_ = calibration_before_;
    return open(StaffScreen::Menu, std::string(words_[StaffWord::OldBack]));
  }
  if (time - last_event_ > (open_ == StaffScreen::Pad ? pad_seconds : pages_seconds)) close();
}

void Staff::step(double time, const interface::ScreenShape& shape, gles::Holdings& holdings) {
  if (!lock_.has_pin()) return;
  if (!is_open() && gesture_.is_made(time)) {
    last_event_ = time;
    words_ = words_in_use_();
    open(StaffScreen::Pad);
  }
  take_lock_answer(time);
  close_in_time(time);
  if (!is_open()) return;
  if (shape_ != shape) page_wanted_ = true;
  if (page_wanted_ && !making_.valid()) make_page(shape);
  if (settings_.repeats_exactly && making_.valid()) making_.wait();
  take_page(holdings);
}

void Staff::make_page(const interface::ScreenShape& shape) {
  page_wanted_ = false;
  shape_ = shape;
  StaffLook look = look_();
  StaffPageRequest request{.screen = *open_,
                           .shape = shape,
                           .words = words_,
                           .livery = std::move(look.livery),
                           .message = message_,
                           .facts = {},
                           .mark = touched_.size(),
                           .first_texture = first_texture + (1 - bank_) * most_staff_texts};
  if (open_ == StaffScreen::Diagnose) request.facts = facts_(words_);
  making_ = std::async(std::launch::async,
                       [request = std::move(request), set_text = std::move(look.set_text),
                        slow_facts = slow_facts_]() mutable {
                         StaffPage page;
                         guarded("laying out a page for staff", [&] {
                           if (request.screen == StaffScreen::Diagnose)
                             for (StaffFact& fact : slow_facts(request.words))
                               request.facts.push_back(std::move(fact));
                           page = make_staff_page(request, set_text);
                         });
                         return page;
                       });
}

void Staff::take_page(gles::Holdings& holdings) {
  if (!is_ready(making_)) return;
  StaffPage next = making_.get();
  if (page_)
    for (const interface::PieceUpload& old : page_->uploads) holdings.release(old.texture);
  for (const auto& [texture, text, picture] : next.uploads)
    holdings.add_text(texture, text.width, text.height, text.coverage);
  for (interface::PieceUpload& upload : next.uploads) upload.text.coverage = {};
  page_ = std::move(next);
  bank_ = 1 - bank_;
  constexpr std::size_t dots_focus_and_rings = 64;
  list_.quads.reserve(page_->quads.size() + dots_focus_and_rings);
}

const scene::DrawList& Staff::over(const scene::DrawList& list) noexcept {
  // NOLINTNEXTLINE(bugprone-return-const-ref-from-parameter): the guide's list outlives the frame
  if (!is_open() || !page_) return list;
  list_.floor = list.floor;
  list_.camera = list.camera;
  list_.quads.clear();
  for (std::size_t i = 0; i < page_->quads.size(); ++i) {
    if (i == 1) draw_focus();  // on the paper, below the button
    list_.quads.push_back(page_->quads[i]);
  }
  if (page_->screen == StaffScreen::Pad) draw_entry();
  draw_fingers();
  return list_;
}

/// The figures that were typed, as dots.
void Staff::draw_entry() noexcept {
  const float size = 2 * page_->unit_px, gap = 1.6F * page_->unit_px;
  const auto count = static_cast<float>(typed_.size());
  const float whole = (count * size + (count - 1) * gap) / page_->width;
  float x = page_->entry.x + (page_->entry.width - whole) / 2;
  for (std::size_t i = 0; i < typed_.size(); ++i) {
    scene::Quad dot;
    dot.rect = {x, page_->entry.y + (page_->entry.height - size / page_->height) / 2,
                size / page_->width, size / page_->height};
    dot.colour = page_->theme.ink;
    dot.corner = size / 2 / std::min(page_->width, page_->height);
    list_.quads.push_back(dot);
    x += (size + gap) / page_->width;
  }
}

/// A frame about what the keypad would press: what of it the button does not cover.
void Staff::draw_focus() noexcept {
  if (focus_ < 0 || focus_ >= static_cast<int>(page_->buttons.size())) return;
  const scene::Rect& rect = page_->buttons[static_cast<std::size_t>(focus_)].rect;
  const float bar = 0.6F * page_->unit_px;
  const float x = bar / page_->width, y = bar / page_->height;
  scene::Quad frame;
  frame.rect = {rect.x - x, rect.y - y, rect.width + 2 * x, rect.height + 2 * y};
  frame.colour = page_->theme.focus;
  frame.corner = (1.5F * page_->unit_px + bar) / std::min(page_->width, page_->height);
  list_.quads.push_back(frame);
}

/// A ring at every finger, where it is felt.
void Staff::draw_fingers() noexcept {
  const float size = 9 * page_->unit_px;
  for (const Finger& finger : fingers_) {
    scene::Quad ring;
    ring.fill = scene::QuadFill::Ring;
    ring.rect = {finger.at.x - size / 2 / page_->width, finger.at.y - size / 2 / page_->height,
                 size / page_->width, size / page_->height};
    ring.softness = 0.5F * page_->unit_px / std::min(page_->width, page_->height);
    ring.colour = page_->theme.invitation;
    list_.quads.push_back(ring);
  }
}

}  // namespace docent::kiosk
