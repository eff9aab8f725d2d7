// What does a letter cost who searches among thousands of exhibits in twelve languages, beside
// looking through all their names for it?

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <random>
#include <string>
#include <vector>

#include "runtime/search/fold.h"
#include "runtime/search/index.h"
#include "tests/runtime/search/made_title.h"

using namespace docent;

namespace {

template <class Work>
double microseconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
  return took.count();
}

void print(const char* name, std::vector<double> times) {
  std::ranges::sort(times);
  fmt::print("{:<12} {:>10.1f} {:>10.1f} {:>10.1f}\n", name, times[times.size() / 2],
             times[times.size() * 99 / 100], times.back());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Times a search by each letter that is typed");
  std::uint32_t exhibits = 5000;
  int queries = 60;
  app.add_option("--exhibits", exhibits)->check(CLI::Range(1U, 1'000'000U));
  app.add_option("--queries", queries)->check(CLI::PositiveNumber);
  CLI11_PARSE(app, argc, argv);

  constexpr std::uint8_t languages = 12;
  std::mt19937 random(11);
  search::IndexBuilder builder(exhibits);
  std::vector<std::u16string> names;
  for (std::uint32_t i = 0; i < exhibits; ++i)
    for (std::uint8_t language = 0; language < languages; ++language) {
      const std::string title = test::made_title(random, language % test::made_scripts);
      builder.add(i, language, 0, title);
      names.push_back(search::folded(title));
    }
  search::Index index;
  const double built = microseconds([&] { index = std::move(builder).build(); });
  fmt::print("{} exhibits in {} languages: {} starts, {} words, made in {:.0f} ms\n", exhibits,
             languages, index.starts.size(), index.words.size(), built / 1000);

  search::SearchDesk desk;
  std::vector<double> ours, scan;
  std::size_t found = 0;
  for (int n = 0; n < queries; ++n) {
    const std::u16string whole = names[random() % names.size()];
    for (std::size_t length = 1; length <= std::min<std::size_t>(whole.size(), 24); ++length) {
      const std::u16string query = whole.substr(0, length);
      ours.push_back(microseconds([&] { found += search::find(index, query, 0, desk).size(); }));
      // Without mistakes, order or groups: the least that anybody would do.
      scan.push_back(microseconds([&] {
        for (const std::u16string& name : names) found += name.find(query) != name.npos ? 1 : 0;
      }));
    }
  }
  fmt::print("{:<12} {:>10} {:>10} {:>10}   us a letter, {} found\n", "", "median", "99 %", "most",
             found);
  print("docent", ours);
  print("all names", scan);
}
