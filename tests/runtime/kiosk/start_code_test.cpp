#include "runtime/kiosk/start_code.h"

#include <dlfcn.h>
#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "runtime/kiosk/allocations.h"
#include "tests/support/kiosk_run.h"

namespace docent::kiosk::start_code_test {
namespace {

/// Resident kilobytes of a library's pages that nobody has written to, and of all its others.
struct Resident {
  long untouched = 0, own = 0;
};

Resident resident(const std::string& library) {
  std::ifstream maps("/proc/self/smaps");
  Resident sum;
  bool is_it = false;
  for (std::string line; std::getline(maps, line);) {
    std::istringstream words(line);
    std::string key;
    long kilobytes = 0;
    words >> key >> kilobytes;
    if (key.find('-') != std::string::npos && key.back() != ':')
      is_it = line.find(library) != std::string::npos;
    else if (is_it && key.ends_with("_Clean:"))
      sum.untouched += kilobytes;
    else if (is_it && key.ends_with("_Dirty:"))
      sum.own += kilobytes;
  }
  return sum;
}

/// The largest library that everybody has who draws without a graphics processor.
TEST(CodeOfTheStart, IsGivenBackAndComesBackWhereItIsNeeded) {
  void* llvm = dlopen("libLLVM-15.so.1", RTLD_NOW | RTLD_LOCAL);
  if (llvm == nullptr) GTEST_SKIP() << "there is no libLLVM-15 here";
  const auto create = reinterpret_cast<void* (*)()>(dlsym(llvm, "LLVMContextCreate"));
  const auto dispose = reinterpret_cast<void (*)(void*)>(dlsym(llvm, "LLVMContextDispose"));
  if (create == nullptr || dispose == nullptr) GTEST_SKIP() << "it is not the LLVM expected";
  dispose(create());
  const Resident before = resident("libLLVM");
  const std::uint64_t allocations = allocations_on_this_thread().all;

  give_back_code_of_start();

  EXPECT_EQ(allocations_on_this_thread().all, allocations);
  const Resident after = resident("libLLVM");
  EXPECT_GT(before.untouched, 500);
  EXPECT_LT(after.untouched, before.untouched / 2);
  EXPECT_EQ(after.own, before.own);  // what the linker relocated is still there
  void* again = create();            // and the code works
  EXPECT_NE(again, nullptr);
  dispose(again);
}

TEST(TheWholeProgram, IsAtMost120MegabytesOnAScreenOf1080Lines) {
#ifndef NDEBUG
  GTEST_SKIP() << "what is released is";
#endif
  const test::VisitRun visit("1 tap @exhibit:tripod-ding\n4 quit\n");
  const test::ProgramRun run =
      visit.play("--stats '" + visit.file("stats.json").string() + "'", "1920x1080");
  ASSERT_EQ(run.exit_code, 0) << run.err;

  EXPECT_LE(test::number_in(test::text_of(visit.file("stats.json")), "rss_mb"), 120);
}

/// At the end of a visit with an arrival, three languages, five ways of three kinds, and speech,
/// beside a program that draws nothing.
TEST(TheWholeProgram, KeepsAtMost60MegabytesForItself) {
#ifndef NDEBUG
  GTEST_SKIP() << "what is released is";
#endif
  const test::VisitRun visit(
      "1 tap @exhibit:tripod-ding\n3 tap @walk\n4 tap @speak\n16 tap @language:zh\n"
      "18 tap @exhibit:jade-disc\n20 tap @route:skeleton\n24 tap @language:ar\n"
      "26 tap @exhibit:fish-mosaic\n28 tap @route:offset\n32 tap @language:en\n34 quit\n");
  const test::ProgramRun run =
      visit.play("--stats '" + visit.file("stats.json").string() + "' --speech '" +
                     visit.file("speech.txt").string() + "'",
                 "1920x1080");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  const test::ProgramRun empty = test::run_program("empty_egl", "");
  ASSERT_EQ(empty.exit_code, 0) << empty.err;

  const std::string stats = test::text_of(visit.file("stats.json"));
  const double own = test::number_in(stats, "anonymous_mb") - std::stod(empty.out);
  RecordProperty("own_megabytes", std::to_string(own));
  EXPECT_LE(own, 60);
  EXPECT_EQ(test::number_in(stats, "routes"), 5);
  EXPECT_GT(std::filesystem::file_size(visit.file("speech.txt")), 500) << "it spoke";
}

}  // namespace
}  // namespace docent::kiosk::start_code_test
