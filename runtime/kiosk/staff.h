#pragma once

#include <array>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "platform/gles/holdings.h"
#include "runtime/input/calibration.h"
#include "runtime/input/staff_gesture.h"
#include "runtime/kiosk/staff_lock.h"
#include "runtime/kiosk/staff_page.h"
#include "runtime/scene/draw_list.h"

namespace docent::kiosk {

struct StaffSettings {
  std::string pin;               ///< Its hash; empty: nothing opens the staff's screens.
  std::filesystem::path folder;  ///< Where a calibration is kept; empty: nowhere.
  bool repeats_exactly = false;  ///< A simulated run: waits for what is worked out beside it.
};

/// Colours, and who sets letters.
struct StaffLook {
  Livery livery;
  interface::SetText set_text;
};

/// The staff's screens over the guide: opened by a gesture and a PIN, they end the program,
/// calibrate the glass, and tell what is running. While they are open, new touches and all keys are
/// theirs; fingers that were down before stay the guide's until they leave.
///
/// For the frame thread. Pages, PINs and files are worked out on threads of their own; while the
/// screens are closed nothing here allocates. Time is a value, in seconds.
class Staff {
 public:
  /// What the pages say, in the language that is on the glass; asked when they are opened.
  using Words = std::function<StaffWords()>;
  /// Facts for the page that tells what is running; asked when it is opened.
  using Facts = std::function<std::vector<StaffFact>(const StaffWords&)>;

  /// What the pages wear: that of the museum that is shown; asked for each of them.
  using Look = std::function<StaffLook()>;

  /// `slow_facts` are asked on another thread.
  Staff(StaffSettings settings, Words words, Look look, Facts facts, Facts slow_facts);
  ~Staff();
  Staff(const Staff&) = delete;
  Staff& operator=(const Staff&) = delete;

  /// Takes an event of the glass as it came. False where it is the guide's: then it gets it as
  /// corrected() says.
  bool take(const input::InputEvent& event, double time);
  input::InputEvent corrected(input::InputEvent event) const noexcept;

  /// Goes on: opens and closes pages, takes answers, carries texts to what is drawn.
  void step(double time, const interface::ScreenShape& shape, gles::Holdings& holdings);

  bool is_open() const noexcept { return open_.has_value(); }
  /// What to draw: `list` itself while the screens are closed.
  const scene::DrawList& over(const scene::DrawList& list) noexcept;

  /// Other holdings are drawn from now on: what is open has to be made anew.
  void lost_textures() noexcept { page_wanted_ = is_open(); }

  /// Staff want the program to end.
  bool wants_exit() const noexcept { return exit_; }

 private:
  static constexpr std::size_t most_fingers = 32;
  struct Finger {
    input::Contact raw, at;
    int button = -1;
  };

  void open(StaffScreen screen, std::string message = {});
  void close() noexcept;
  void press(StaffAction action, double time);
  void press_key(const input::InputEvent& event, double time);
  void touch_mark(const input::Contact& raw, double time);
  void calibrate_from(double time);
  void keep_calibration();
  void take_lock_answer(double time);
  void close_in_time(double time);
  void make_page(const interface::ScreenShape& shape);
  void take_page(gles::Holdings& holdings);
  int button_at(float x, float y) const noexcept;
  Finger* finger(std::uint32_t id) noexcept;
  void draw_entry() noexcept;
  void draw_focus() noexcept;
  void draw_fingers() noexcept;

  StaffSettings settings_;
  Words words_in_use_;
  StaffWords words_;  ///< While the screens are open.
  Look look_;
  Facts facts_, slow_facts_;
  input::StaffGesture gesture_;
  StaffLock lock_;
  input::Calibration calibration_, calibration_before_;
  std::optional<StaffScreen> open_;
  std::string message_;
  std::string typed_;
  std::vector<input::TouchedMark> touched_;
  double last_event_ = 0;
  double confirm_until_ = 0;
  bool exit_ = false;

  bool page_wanted_ = false;
  interface::ScreenShape shape_;
  std::future<StaffPage> making_;
  std::optional<StaffPage> page_;
  std::uint32_t bank_ = 0;  ///< Which of the two ranges of texture numbers page_ has.
  int focus_ = -1;
  std::vector<Finger> fingers_;
  std::future<void> saving_;
  scene::DrawList list_;
};

/// The calibration in a folder; the plain one where there is none, and a sentence on standard error
/// where it cannot be read.
input::Calibration load_calibration(const std::filesystem::path& folder);

/// Of $STATE_DIRECTORY, which systemd sets, the folder for what staff set at this glass; empty
/// where there is none.
std::filesystem::path staff_folder();

}  // namespace docent::kiosk
