// What the unit, the lock and the udev rule promise each other.

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "runtime/kiosk/kiosk.h"
#include "tests/support/run_program.h"

namespace docent::test::units_test {
namespace {

using testing::HasSubstr;

std::string deployed(const char* file) {
  return text_of(source_dir() / "deploy" / file);
}

TEST(Units, DoNotStartAgainWhatStaffEndedOnTheGlass) {
  const std::string unit = deployed("systemd/docent.service");

  EXPECT_THAT(unit,
              HasSubstr(fmt::format("\nRestartPreventExitStatus={}\n", kiosk::ended_by_staff)));
  EXPECT_THAT(unit, HasSubstr(fmt::format("\nSuccessExitStatus={}\n", kiosk::ended_by_staff)));
}

TEST(Units, HoldKeyboardsWhileTheKioskLivesAndNoLonger) {
  const std::string unit = deployed("systemd/docent.service");
  const std::string lock = deployed("systemd/docent-lock.service");

  EXPECT_THAT(unit, HasSubstr("\nWants=docent-lock.service\n"));
  EXPECT_THAT(unit, HasSubstr("\nAfter=docent-lock.service\n"));
  EXPECT_THAT(lock, HasSubstr("\nStopWhenUnneeded=yes\n"));
  EXPECT_THAT(lock, HasSubstr("\nExecStart=/usr/bin/touch /run/docent-locked\n"));
  EXPECT_THAT(lock, HasSubstr("\nExecStop=/usr/bin/rm -f /run/docent-locked\n"));
}

TEST(Units, GiveALoginOnlyByWhatIsRefusedWhileTheKioskStarts) {
  const std::string lock = deployed("systemd/docent-lock.service");
  const std::string console = deployed("systemd/docent-console.service");

  EXPECT_THAT(lock, testing::ContainsRegex("\nExecStopPost=[^\n]*systemctl start --no-block "
                                           "--job-mode=fail docent-console.service"));
  EXPECT_THAT(lock, testing::Not(HasSubstr("getty@tty1")));
  EXPECT_THAT(console, HasSubstr("\nConflicts=docent.service\n"));
  EXPECT_THAT(console, HasSubstr("\nRequires=getty@tty1.service\n"));
}

TEST(Units, WaitForTheGuideLongerThanTheBootLoadersDiskStaysMounted) {
  const std::string unit = deployed("disk/docent-good.service");

  EXPECT_THAT(deployed("image"), HasSubstr("/efi     vfat  umask=0077,noauto,x-systemd.automount,"
                                           "x-systemd.idle-timeout="));
  for (const char* key : {"RequiresMountsFor=", "Requires=", "BindsTo="})
    EXPECT_THAT(unit, testing::Not(testing::ContainsRegex(fmt::format("{}[^\n]*efi", key))));
  EXPECT_THAT(unit, HasSubstr("\nAfter=efi.automount\n"));
}

TEST(UdevRule, InhibitsNoKeyboardWithoutTheLock) {
  const std::string rules = deployed("udev/70-docent.rules");

  EXPECT_THAT(rules, HasSubstr("\nTEST==\"/run/docent-locked\", ATTR{inhibited}=\"1\"\n"));
  EXPECT_THAT(rules, HasSubstr("\nTEST!=\"/run/docent-locked\", ATTR{inhibited}=\"0\"\n"));
  std::size_t inhibiting = 0;
  for (std::size_t at = rules.find("ATTR{inhibited}=\"1\""); at != std::string::npos;
       at = rules.find("ATTR{inhibited}=\"1\"", at + 1))
    ++inhibiting;
  EXPECT_EQ(inhibiting, 1U);
}

}  // namespace
}  // namespace docent::test::units_test
