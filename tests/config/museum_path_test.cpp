#include "config/museum_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

#include "tests/support/temporary_folder.h"

namespace docent::config::museum_path_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class MuseumPath : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder() / "images/east");
    write("images/jar.png");
    write("images/east/lute.png");
  }
  const fs::path& folder() const { return folder_.path(); }
  void write(const std::string& name) const { std::ofstream(folder() / name) << "x"; }
  std::optional<PathFault> fault(const std::string& name, Wanted wanted = Wanted::File) const {
    return MuseumPaths(folder()).fault(name, wanted);
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(MuseumPath, OfAFileInTheMuseumIsRight) {
  EXPECT_FALSE(fault("images/jar.png").has_value());
  EXPECT_FALSE(fault("./images/../images/jar.png").has_value());
  EXPECT_FALSE(fault("images", Wanted::Folder).has_value());
}

TEST_F(MuseumPath, IsAnsweredWithTheRightName) {
  EXPECT_EQ(fault("Images/JAR.png")->hint, "it is called 'images/jar.png'");
  EXPECT_EQ(fault("images/jra.png")->hint, "did you mean 'images/jar.png'?");
  EXPECT_EQ(fault("images/jar.jpg")->hint, "did you mean 'images/jar.png'?");
  EXPECT_EQ(fault("lute.png")->hint,
            "write \"images/east/lute.png\", where there is one, or move that file");
  EXPECT_EQ(fault("images\tjar.png")->hint, "write folders with a slash: \"images/tjar.png\"");
  EXPECT_EQ(fault("images\\jar.png")->hint, "write \"images/jar.png\"");
  EXPECT_EQ(fault("C:/Users/me/lute.png")->hint,
            "write \"images/east/lute.png\", which is in the museum's folder");
}

TEST_F(MuseumPath, NeverLeadsOut) {
  fs::create_symlink("/etc", folder() / "etc");
  for (const char* name : {"/etc/passwd", "../jar.png", "images/../../jar.png", "etc/passwd",
                           "~/jar.png", "file:///etc/passwd", "https://example.org/jar.png"})
    EXPECT_EQ(fault(name)->code, "outside-museum") << name;
}

TEST_F(MuseumPath, IsNeitherAFolderNorAPipeNorALinkToNothing) {
  ASSERT_EQ(::mkfifo((folder() / "pipe").c_str(), 0600), 0);
  fs::create_symlink("nothing", folder() / "link");
  fs::create_symlink("loop", folder() / "loop");

  EXPECT_THAT(fault("images")->message, HasSubstr("is a folder"));
  EXPECT_THAT(fault("images/jar.png", Wanted::Folder)->message, HasSubstr("should be a folder"));
  EXPECT_THAT(fault("pipe")->message, HasSubstr("is no file, but a device or a pipe"));
  EXPECT_THAT(fault("link")->message, HasSubstr("a link to a file that is not there"));
  EXPECT_THAT(fault("loop")->message, HasSubstr("a link that leads back to itself"));
  EXPECT_THAT(fault(std::string(300, 'x'))->message, HasSubstr("cannot be as long"));
}

TEST_F(MuseumPath, OfAnEmptyFileIsRightForATextOnly) {
  std::ofstream(folder() / "empty");

  EXPECT_EQ(fault("empty")->code, "empty-file");
  EXPECT_FALSE(fault("empty", Wanted::Text).has_value());
}

TEST_F(MuseumPath, OfALostFolderIsToldQuickly) {
  MuseumPaths paths(folder());
  for (int i = 0; i < 300; ++i) write("images/" + std::to_string(i) + ".png");

  for (int i = 0; i < 2000; ++i)
    EXPECT_EQ(paths.fault("photos/" + std::to_string(i) + ".jpg")->code, "missing-file");
}

}  // namespace
}  // namespace docent::config::museum_path_test
