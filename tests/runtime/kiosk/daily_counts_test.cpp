#include "runtime/kiosk/daily_counts.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

namespace docent::kiosk::daily_counts_test {
namespace {

using Kind = CountedCell::Kind;

/// What one visitor did, as it is counted.
struct OneVisit {
  std::string language;
  std::set<std::string> exhibits, routes;
};

CellCounts counted(const std::vector<OneVisit>& visits) {
  CellCounts counts;
  for (const OneVisit& visit : visits) {
    ++counts[{Kind::Language, visit.language}];
    for (const std::string& id : visit.exhibits) ++counts[{Kind::Exhibit, id}];
    for (const std::string& name : visit.routes) ++counts[{Kind::Route, name}];
  }
  return counts;
}

const std::vector<std::string> languages{"ar", "en", "zh"};
const std::vector<std::string> routes{"offset", "shortest", "skeleton"};
const std::vector<std::string> exhibits{"amphora", "disc", "jar", "ship", "vase"};

/// Whoever asked for an exhibit was led by some kind of way; nobody was led to nothing.
OneVisit some_visit() {
  OneVisit visit;
  // Mostly one language and one kind, so that there are small cells and large ones.
  visit.language = *rc::gen::weightedElement<std::string>(
      {{12, languages[1]}, {2, languages[0]}, {1, languages[2]}});
  const int wanted = *rc::gen::inRange(0, 3);
  for (int i = 0; i < wanted; ++i)
    visit.exhibits.insert(exhibits[static_cast<std::size_t>(
        *rc::gen::weightedElement<int>({{9, 0}, {5, 1}, {3, 2}, {2, 3}, {1, 4}}))]);
  if (visit.exhibits.empty()) return visit;
  visit.routes.insert(
      *rc::gen::weightedElement<std::string>({{9, routes[1]}, {2, routes[0]}, {1, routes[2]}}));
  return visit;
}

DailyCounts some_day() {
  const auto count = *rc::gen::inRange<std::size_t>(0, 60);
  std::vector<OneVisit> visits;
  for (std::size_t i = 0; i < count; ++i) visits.push_back(some_visit());
  return {.day = "2026-11-23", .touches = 7 * count, .visits = counted(visits)};
}

RC_GTEST_PROP(PublishedCounts, NeverHoldACellOfFewerThanFiveVisits, ()) {
  const PublishedCounts told = published(some_day());

  for (const auto& [cell, count] : told.cells) RC_ASSERT(count >= least_published);
  RC_ASSERT(told.visits == 0 || told.visits >= least_published);
}

RC_GTEST_PROP(PublishedCounts, AreTheSameWhateverTheSmallCellsHold, ()) {
  const DailyCounts day = some_day();
  DailyCounts other = day;
  for (const auto* names : {&languages, &routes, &exhibits})
    for (const std::string& name : *names) {
      const Kind kind = names == &languages ? Kind::Language
                        : names == &routes  ? Kind::Route
                                            : Kind::Exhibit;
      if (!day.visits.contains({kind, name}) || day.visits.at({kind, name}) < least_published)
        other.visits[{kind, name}] = *rc::gen::inRange<std::uint64_t>(0, least_published);
    }

  RC_ASSERT(published(other) == published(day));
}

/// Visits that would be published as this is: those of each language, and round a table the
/// exhibits that were asked for, so that each of the visits led somewhere asked for one at least.
std::vector<OneVisit> visits_published_as(const PublishedCounts& told) {
  std::vector<OneVisit> visits;
  std::uint64_t led = 0;
  for (const auto& [cell, count] : told.cells) {
    if (cell.kind == Kind::Language)
      visits.resize(visits.size() + count, {.language = cell.name, .exhibits = {}, .routes = {}});
    else
      led = std::max(led, count);
  }
  std::uint64_t exhibit = 0, route = 0;
  for (const auto& [cell, count] : told.cells)
    for (std::uint64_t i = 0; i < count; ++i) {
      if (cell.kind == Kind::Exhibit) visits.at(exhibit++ % led).exhibits.insert(cell.name);
      if (cell.kind == Kind::Route) visits.at(route++ % led).routes.insert(cell.name);
    }
  return visits;
}

/// Another visitor's doings beside those: with `more` visits in this cell.
std::vector<OneVisit> with_more(std::vector<OneVisit> visits, const CountedCell& cell,
                                std::uint64_t more) {
  for (std::uint64_t i = 0; i < more; ++i) {
    if (cell.kind == Kind::Language) {
      visits.push_back({.language = cell.name, .exhibits = {}, .routes = {}});
      continue;
    }
    const auto led = std::ranges::find_if(visits, [&](const OneVisit& visit) {
      const auto& names = cell.kind == Kind::Exhibit ? visit.exhibits : visit.routes;
      return !visit.exhibits.empty() && !names.contains(cell.name);
    });
    // Where nobody else was led anywhere, this visitor alone was, and in a language of few.
    OneVisit& visit =
        led != visits.end() ? *led : visits.emplace_back(OneVisit{"nobody's", {"none"}, {"none"}});
    (cell.kind == Kind::Exhibit ? visit.exhibits : visit.routes).insert(cell.name);
  }
  return visits;
}

RC_GTEST_PROP(PublishedCounts, GiveNoSmallCellAwayBySumsOrDifferences, ()) {
  const PublishedCounts told = published(some_day());
  const std::vector<OneVisit> visits = visits_published_as(told);

  // For every cell left out, each number below five is that of some day which looks the same.
  for (const auto& [kind, names] :
       {std::pair(Kind::Language, languages), {Kind::Route, routes}, {Kind::Exhibit, exhibits}})
    for (const std::string& name : names)
      for (std::uint64_t small = 0; small < least_published; ++small) {
        if (told.cells.contains({kind, name})) continue;
        PublishedCounts same =
            published({.day = told.day,
                       .touches = 0,
                       .visits = counted(with_more(visits, {kind, name}, small))});
        same.touches = told.touches;
        RC_ASSERT(same == told);
      }
}

TEST(PublishedCounts, LeaveOutWhatTheLargerSumsWouldTell) {
  // Five exhibits were asked for four times each: that twenty were led would tell each of them.
  DailyCounts day{.day = "2026-11-23", .touches = 100, .visits = {}};
  day.visits[{Kind::Language, "en"}] = 20;
  day.visits[{Kind::Route, "shortest"}] = 20;
  for (const std::string& id : exhibits) day.visits[{Kind::Exhibit, id}] = 4;

  const PublishedCounts told = published(day);

  EXPECT_EQ(told.visits, 20U);
  EXPECT_EQ(told.cells, (CellCounts{{{Kind::Language, "en"}, 20}}));
}

TEST(PublishedCounts, AreLinesOfCsv) {
  DailyCounts day{.day = "2026-11-23", .touches = 90, .visits = {}};
  day.visits[{Kind::Language, "en"}] = 12;
  day.visits[{Kind::Language, "zh"}] = 4;
  day.visits[{Kind::Exhibit, "jar"}] = 9;
  day.visits[{Kind::Route, "shortest"}] = 9;

  EXPECT_EQ(to_csv(published(day)),
            "2026-11-23,visits,,12\n2026-11-23,touches,,90\n2026-11-23,exhibit,jar,9\n"
            "2026-11-23,route,shortest,9\n2026-11-23,language,en,12\n");
}

RC_GTEST_PROP(DailyCounts, ComeBackFromTheirText, ()) {
  const DailyCounts day = some_day();

  RC_ASSERT(daily_counts_from(to_text(day)) == day);
}

TEST(DailyCounts, AreNotReadFromOtherText) {
  EXPECT_EQ(daily_counts_from(""), std::nullopt);
  EXPECT_EQ(daily_counts_from("day,kind,name,count\n"), std::nullopt);
  EXPECT_EQ(daily_counts_from("day,kind,name,count\n2026-11-23,touches,,x\n"), std::nullopt);
  EXPECT_EQ(daily_counts_from("day,kind,name,count\n2026-11-23,exhibit,jar\n"), std::nullopt);
  EXPECT_EQ(
      daily_counts_from("day,kind,name,count\n2026-11-23,touches,,1\n2026-11-24,touches,,1\n"),
      std::nullopt);
}

TEST(DailyCounts, AreSums) {
  DailyCounts day{.day = "2026-11-23", .touches = 1, .visits = {{{Kind::Exhibit, "jar"}, 2}}};

  day += {.day = {},
          .touches = 2,
          .visits = {{{Kind::Exhibit, "jar"}, 3}, {{Kind::Exhibit, "vase"}, 1}}};

  EXPECT_EQ(day.touches, 3U);
  EXPECT_EQ(day.visits, (CellCounts{{{Kind::Exhibit, "jar"}, 5}, {{Kind::Exhibit, "vase"}, 1}}));
}

}  // namespace
}  // namespace docent::kiosk::daily_counts_test
