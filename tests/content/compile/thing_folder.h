#pragma once

#include <optional>
#include <string>
#include <vector>

#include "content/compile/compile.h"
#include "runtime/schema/elements.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::test_things {

/// 300 by 400 by 300, whatever its unit.
inline constexpr const char* pyramid =
    "v 0 0 0\nv 300 0 0\nv 300 0 300\nv 0 0 300\nv 150 400 150\n"
    "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

struct Compiled {
  std::optional<Museum> museum;
  std::vector<std::string> told;  ///< "code: message"
};

/// The small museum with a thing in it, an OBJ, of which `exhibit` says where it is.
struct Folder {
  explicit Folder(const std::string& exhibit, const std::string& model = pyramid) {
    it.write("models/thing.obj", model);
    it.write("exhibits/thing.toml",
             "[[exhibit]]\nid = \"thing\"\nfacing = 270\ntitle.en = \"Thing\"\n"
             "title.ar = \"شيء\"\nimage = \"images/disc.svg\"\nmodel = \"models/thing.obj\"\n" +
                 exhibit);
  }
  Compiled compiled(bool with_motion, bool only_check) const {
    Report report;
    Progress progress(Progress::Output::Nothing);
    CompileOptions options;
    options.sources = {it.path().string()};
    options.with_motion = with_motion;
    options.with_speech = false;
    options.only_check = only_check;
    Compiled compiled{compile(options, report, progress), {}};
    for (const Diagnostic& one : report.in_order())
      compiled.told.push_back(one.code + ": " + one.message);
    return compiled;
  }
  test::MuseumFolder it;
};

}  // namespace docent::compile::test_things
