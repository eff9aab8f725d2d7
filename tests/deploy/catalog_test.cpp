// deploy/systemd/docent.catalog explains every message that the kiosk gives the journal.

#include "tests/deploy/catalog.h"

#include <gmock/gmock.h>

#include <cstdlib>

#include "platform/journal/message.h"
#include "tests/deploy/made_file.h"
#include "tests/support/run_program.h"

namespace docent::test::catalog_test {
namespace {

std::filesystem::path catalog_file() {
  return source_dir() / "deploy/systemd/docent.catalog";
}

TEST(MessageCatalog, SaysWhatTheTableSays) {
  expect_made(catalog_file(), message_catalog());
}

TEST(MessageCatalog, IsUnderstoodByTheJournal) {
  if (std::system("command -v journalctl >/dev/null") != 0)  // NOLINT(bugprone-command-processor)
    GTEST_SKIP() << "systemd is not installed";
  const TemporaryFolder folder;
  const std::filesystem::path installed = folder.path() / "usr/lib/systemd/catalog";
  std::filesystem::create_directories(installed);
  std::filesystem::create_directories(folder.path() / "var/lib/systemd/catalog");
  std::filesystem::copy(catalog_file(), installed / "docent.catalog");
  const std::string journalctl = "journalctl --root='" + folder.path().string() + "' ";
  const std::string out = (folder.path() / "out").string();

  const std::string ask =
      journalctl + "--update-catalog && " + journalctl + "--list-catalog >" + out;
  ASSERT_EQ(std::system(ask.c_str()), 0);  // NOLINT(bugprone-command-processor)

  for (const journal::MessageKind& kind : journal::message_kinds())
    EXPECT_THAT(text_of(out),
                testing::HasSubstr(std::string(kind.id) + " docent: " + std::string(kind.subject)));
}

}  // namespace
}  // namespace docent::test::catalog_test
