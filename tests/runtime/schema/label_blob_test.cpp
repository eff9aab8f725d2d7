#include "runtime/schema/label_blob.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>
#include <ranges>

#include "tests/runtime/schema/bytes.h"

namespace docent::schema::label_blob_test {
namespace {

using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::IsEmpty;

bool same(const LabelTable& a, const LabelTable& b) {
  const auto same_cost = [](HubCost p, HubCost q) { return p.hub == q.hub && p.cost == q.cost; };
  return a.first == b.first && std::ranges::equal(a.hub, b.hub, same_cost) && a.link == b.link &&
         a.parent == b.parent;
}

void add_station(LabelTable& table, const std::vector<std::uint32_t>& hubs) {
  const auto entries = static_cast<std::uint32_t>(hubs.size());
  for (const std::uint32_t hub : hubs) {
    table.hub.push_back({hub, *rc::gen::arbitrary<std::uint32_t>()});
    table.link.push_back(*rc::gen::element(HubLabels::roll, 0U, 127U, 128U, 70'000U, 0xfffffffeU));
    table.parent.push_back(*rc::gen::arbitrary<bool>()
                               ? LabelTable::no_parent
                               : table.first.back() + *rc::gen::inRange(0U, entries));
  }
  table.first.push_back(table.first.back() + entries);
}

/// Stations with and without entries, of hubs near to each other and as far apart as can be.
LabelTable some_table() {
  LabelTable table;
  const int stations = *rc::gen::inRange(0, 6);
  for (int i = 0; i < stations; ++i) {
    const std::uint32_t most =
        *rc::gen::element(3U, 300U, std::numeric_limits<std::uint32_t>::max());
    auto hubs = *rc::gen::container<std::vector<std::uint32_t>>(
        rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [most](std::uint32_t hub) {
          return most == std::numeric_limits<std::uint32_t>::max() ? hub : hub % (most + 1);
        }));
    std::ranges::sort(hubs);
    const auto repeated = std::ranges::unique(hubs);
    hubs.erase(repeated.begin(), repeated.end());
    add_station(table, hubs);
  }
  return table;
}

RC_GTEST_PROP(LabelBlob, IsReadAsItWasWritten, ()) {
  const LabelTable table = some_table();

  LabelTable read;

  RC_ASSERT(decode(encode(table), read));
  RC_ASSERT(same(read, table));
}

RC_GTEST_PROP(LabelBlob, IsRefusedWhereAnyByteIsMissingOrTooMany, ()) {
  const LabelTable table = some_table();
  auto longer = encode(table);
  const std::size_t size = longer.size();
  longer.push_back(std::byte{0});
  LabelTable read;

  RC_ASSERT(!decode(longer, read));
  for (std::size_t shorter = 0; shorter < size; ++shorter)
    RC_ASSERT(!decode(std::span(longer).first(shorter), read));
  RC_ASSERT(read.hub.empty() && read.first.size() == 1U);
}

TEST(LabelBlob, IsWrittenAsItsHeaderSays) {
  const LabelTable table{.first = {0, 0, 2},
                         .hub = {{3, 0x01020304}, {204, 5}},
                         .link = {HubLabels::roll, 299},
                         .parent = {LabelTable::no_parent, 0}};

  EXPECT_THAT(encode(table), ElementsAreArray(bytes({2,                       //
                                                     0,                       //
                                                     2, 3, 4, 3, 2, 1, 0, 0,  //
                                                     0xc8, 1, 5, 0, 0, 0, 0xac, 2, 1})));
}

TEST(LabelBlob, OfNoStationsIsATableOfNone) {
  LabelTable read{.first = {0, 1}, .hub = {{0, 0}}, .link = {0}, .parent = {0}};

  ASSERT_TRUE(decode(bytes({0}), read));

  EXPECT_THAT(read.first, ElementsAre(0U));
  EXPECT_THAT(read.hub, IsEmpty());
}

TEST(LabelBlob, RefusesWhatIsNoTable) {
  LabelTable read;
  for (const auto& bad : {
           bytes({}),
           bytes({0x80, 0x80, 0x80, 0x80, 0x80, 0}),                 // a count of six bytes
           bytes({0xff, 0xff, 0xff, 0xff, 0x1f}),                    // more than 32 bits
           bytes({0xff, 0xff, 0xff, 0xff, 0xf}),                     // more stations than bytes
           bytes({1, 0xff, 0xff, 0xff, 0xff, 0xf}),                  // more entries than bytes
           bytes({1, 1, 0, 0, 0, 0, 0, 0, 2}),                       // a parent outside
           bytes({1, 2, 0xff, 0xff, 0xff, 0xff, 0xf, 0, 0, 0, 0, 0,  // a hub beyond 32 bits
                  0, 0, 0,    0,    0,    0,    0,   0}),
       })
    EXPECT_FALSE(decode(bad, read));
}

}  // namespace
}  // namespace docent::schema::label_blob_test
