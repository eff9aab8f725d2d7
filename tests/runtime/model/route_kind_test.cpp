#include "runtime/model/route_kind.h"

#include <gtest/gtest.h>

#include <set>
#include <string_view>

namespace docent::route_kind_test {
namespace {

TEST(RouteKinds, AreInTheOrderOfTheirNumbers) {
  for (std::size_t i = 0; i < route_kinds.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(route_kinds[i].kind), i);
    EXPECT_EQ(&info_of(route_kinds[i].kind), &route_kinds[i]);
  }
}

TEST(RouteKinds, AreToldApartByNameByColourAndWithoutColour) {
  std::set<std::string_view> names, legends;
  std::set<std::uint32_t> colours;
  std::set<std::pair<float, float>> patterns;
  std::set<std::pair<double, double>> drawn;
  std::set<int> samples;
  for (const RouteKindInfo& info : route_kinds) {
    names.insert(info.name);
    legends.insert(info.legend);
    colours.insert(info.colour);
    patterns.emplace(info.pattern.period, info.pattern.piece);
    drawn.emplace(info.pattern.drawn_piece, info.pattern.drawn_gap);
    samples.insert(info.pattern.sample_pieces);
  }
  for (const std::size_t different : {names.size(), legends.size(), colours.size(), patterns.size(),
                                      drawn.size(), samples.size()})
    EXPECT_EQ(different, route_kinds.size());
}

}  // namespace
}  // namespace docent::route_kind_test
