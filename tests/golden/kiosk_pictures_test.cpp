#include <gtest/gtest.h>

#include <cstdlib>
#include <span>

#include "platform/png/image.h"
#include "tests/support/kiosk_run.h"

namespace docent::test {
namespace {

Pixels picture(const std::filesystem::path& file) {
  const std::string bytes = text_of(file);
  const auto decoded = decode_image(std::as_bytes(std::span(bytes)));
  return decoded ? *decoded : Pixels{};
}

struct Difference {
  double mean = 0;     ///< Of all channels, of 255.
  double far_off = 0;  ///< Share of the channels that differ by more than a tenth of the range.
};

Difference compare(const Pixels& a, const Pixels& b) {
  Difference difference;
  for (std::size_t i = 0; i < a.rgba.size(); ++i) {
    const int apart = std::abs(std::to_integer<int>(a.rgba[i]) - std::to_integer<int>(b.rgba[i]));
    difference.mean += apart;
    difference.far_off += apart > 25 ? 1 : 0;
  }
  const auto count = static_cast<double>(std::max<std::size_t>(a.rgba.size(), 1));
  difference.mean /= count;
  difference.far_off /= count;
  return difference;
}

/// The pictures that people have looked at, one a screen; DOCENT_UPDATE_GOLDEN=1 writes them anew.
/// Drivers and processors round differently, and a font of another release moves edges of letters:
/// one level in the mean and one channel in a hundred far off allow for that, while a panel that
/// moved, a guide elsewhere or another light do not pass (a guide one step ahead changes more).
TEST(TheKiosk, LooksAsItWasSeenAndApproved) {
  const VisitRun run("0.5 shot " + std::string("welcome.png") +
                     "\n1 key ENTER\n2.5 shot choosing.png\n3 tap @exhibit:tripod-ding\n"
                     "12 shot walking.png\n45 shot arrived.png\n46 tap @language:ar\n"
                     "47.5 shot arabic.png\n48 quit\n");
  const std::filesystem::path golden = source_dir() / "tests/golden";
  const std::filesystem::path here = std::filesystem::current_path();
  std::filesystem::current_path(run.file("a.visit").parent_path());
  const ProgramRun played = run.play("", "960x540");
  std::filesystem::current_path(here);
  ASSERT_EQ(played.exit_code, 0) << played.err;

  for (const char* name :
       {"welcome.png", "choosing.png", "walking.png", "arrived.png", "arabic.png"}) {
    if (std::getenv("DOCENT_UPDATE_GOLDEN") != nullptr)
      std::filesystem::copy_file(run.file(name), golden / name,
                                 std::filesystem::copy_options::overwrite_existing);
    const Pixels now = picture(run.file(name));
    const Pixels approved = picture(golden / name);
    ASSERT_GT(now.rgba.size(), 0U) << name;
    ASSERT_EQ(now.rgba.size(), approved.rgba.size()) << name;
    const Difference difference = compare(now, approved);
    EXPECT_LT(difference.mean, 1.0) << name;
    EXPECT_LT(difference.far_off, 0.01) << name;
  }
}

}  // namespace
}  // namespace docent::test
