#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace docent {

/// What visitors ask for besides exhibits.
enum class PlaceKind : std::uint8_t {
  Toilets,
  AccessibleToilets,
  AllGenderToilets,
  WomensToilets,
  MensToilets,
  BabyChange,
  Exit,
  EmergencyExit,
  Entrance,
  Information,
  Tickets,
  Cloakroom,
  Lockers,
  Cafe,
  Restaurant,
  Shop,
  Lift,
  Stairs,
  Seat,
  Water,
  FirstAid,
  Defibrillator,
  QuietRoom,
  PrayerRoom,
  MeetingPoint,
  LostAndFound,
  CashMachine,
  Telephone,
  Library,
  Auditorium,
  Parking,
  Count,
};
inline constexpr auto place_kind_count = static_cast<std::size_t>(PlaceKind::Count);

/// A kind of place under all the names that it goes by. A further kind is an enumerator, a row
/// here, its words `place_NAME` and its pictogram.
struct PlaceKindInfo {
  PlaceKind kind{};
  std::string_view name;  ///< In museum.toml, on command lines and in scripted visits: stable.
  /// Which wider kind it answers as well: accessible toilets are toilets. Itself where there is
  /// none.
  PlaceKind also{};
  /// Categories of IMDF's amenities, units, openings and occupants that mean it. A category that
  /// is not listed means what it means without its last part: restroom.female as restroom.
  std::array<std::string_view, 8> imdf{};
};

inline constexpr std::array<PlaceKindInfo, place_kind_count> place_kinds{{
    {PlaceKind::Toilets, "toilets", PlaceKind::Toilets, {"restroom", "toilet"}},
    {PlaceKind::AccessibleToilets,
     "accessible_toilets",
     PlaceKind::Toilets,
     {"restroom.wheelchair", "restroom.unisex.wheelchair", "restroom.female.wheelchair",
      "restroom.male.wheelchair", "restroom.transgender.wheelchair"}},
    {PlaceKind::AllGenderToilets,
     "all_gender_toilets",
     PlaceKind::Toilets,
     {"restroom.unisex", "restroom.transgender", "restroom.family"}},
    {PlaceKind::WomensToilets, "womens_toilets", PlaceKind::Toilets, {"restroom.female"}},
    {PlaceKind::MensToilets, "mens_toilets", PlaceKind::Toilets, {"restroom.male"}},
    {PlaceKind::BabyChange, "baby_change", PlaceKind::BabyChange, {"babychanging", "mothersroom"}},
    {PlaceKind::Exit, "exit", PlaceKind::Exit, {"exit"}},
    {PlaceKind::EmergencyExit, "emergency_exit", PlaceKind::EmergencyExit, {"emergencyexit"}},
    {PlaceKind::Entrance, "entrance", PlaceKind::Exit, {"entry", "pedestrian.principal"}},
    {PlaceKind::Information, "information", PlaceKind::Information, {"information", "reception"}},
    {PlaceKind::Tickets, "tickets", PlaceKind::Tickets, {"ticketing", "boxoffice"}},
    {PlaceKind::Cloakroom, "cloakroom", PlaceKind::Cloakroom, {"coatcheck", "baggagestorage"}},
    {PlaceKind::Lockers, "lockers", PlaceKind::Lockers, {"baggagelockers", "lockers", "locker"}},
    {PlaceKind::Cafe,
     "cafe",
     PlaceKind::Cafe,
     {"cafe", "coffee", "coffeeandtea", "bakery", "eatingdrinking", "teahouse", "bar"}},
    {PlaceKind::Restaurant,
     "restaurant",
     PlaceKind::Restaurant,
     {"restaurant", "foodservice", "foodcourt", "cafeteria", "fastfood"}},
    {PlaceKind::Shop,
     "shop",
     PlaceKind::Shop,
     {"shopping", "giftshop", "bookstore", "museumshop", "souvenirshop", "retail"}},
    {PlaceKind::Lift, "lift", PlaceKind::Lift, {"elevator"}},
    {PlaceKind::Stairs, "stairs", PlaceKind::Stairs, {"stairs", "escalator"}},
    {PlaceKind::Seat, "seat", PlaceKind::Seat, {"seat", "seating", "waitingroom", "bench"}},
    {PlaceKind::Water, "water", PlaceKind::Water, {"drinkingfountain"}},
    {PlaceKind::FirstAid, "first_aid", PlaceKind::FirstAid, {"firstaid", "medicalroom"}},
    {PlaceKind::Defibrillator, "defibrillator", PlaceKind::Defibrillator, {"defibrillator"}},
    {PlaceKind::QuietRoom,
     "quiet_room",
     PlaceKind::QuietRoom,
     {"meditation", "quietroom", "serenityroom"}},
    {PlaceKind::PrayerRoom, "prayer_room", PlaceKind::PrayerRoom, {"prayerroom", "chapel"}},
    {PlaceKind::MeetingPoint, "meeting_point", PlaceKind::MeetingPoint, {"meetingpoint"}},
    {PlaceKind::LostAndFound, "lost_and_found", PlaceKind::LostAndFound, {"lostandfound"}},
    {PlaceKind::CashMachine, "cash_machine", PlaceKind::CashMachine, {"atm"}},
    {PlaceKind::Telephone, "telephone", PlaceKind::Telephone, {"payphone", "phone"}},
    {PlaceKind::Library, "library", PlaceKind::Library, {"library"}},
    {PlaceKind::Auditorium,
     "auditorium",
     PlaceKind::Auditorium,
     {"auditorium", "theater", "movietheater", "amphitheater"}},
    {PlaceKind::Parking, "parking", PlaceKind::Parking, {"parking"}},
}};

constexpr const PlaceKindInfo& info_of(PlaceKind kind) noexcept {
  return place_kinds[static_cast<std::size_t>(kind)];
}

/// The names of all kinds, in the order of the table.
inline constexpr auto place_kind_names = [] {
  std::array<std::string_view, place_kind_count> names{};
  std::ranges::transform(place_kinds, names.begin(), &PlaceKindInfo::name);
  return names;
}();

/// The kind of that name.
constexpr std::optional<PlaceKind> place_kind_named(std::string_view name) noexcept {
  const auto info = std::ranges::find(place_kinds, name, &PlaceKindInfo::name);
  return info == place_kinds.end() ? std::nullopt : std::optional(info->kind);
}

/// Is a place of this kind one that somebody looks for who asks for that kind?
constexpr bool answers(PlaceKind kind, PlaceKind asked) noexcept {
  return kind == asked || info_of(kind).also == asked;
}

/// What an IMDF category is, if it is a place that visitors ask for.
constexpr std::optional<PlaceKind> place_kind_of_imdf(std::string_view category) noexcept {
  while (!category.empty()) {
    for (const PlaceKindInfo& info : place_kinds)
      if (std::ranges::find(info.imdf, category) != info.imdf.end()) return info.kind;
    const std::size_t part = category.rfind('.');
    category = category.substr(0, part == std::string_view::npos ? 0 : part);
  }
  return std::nullopt;
}

/// A tag of OpenStreetMap: what is written in its key's value, in full; "*" is anything but no.
struct OsmTag {
  std::string_view key, value;
};
/// What tags mean: all of a rule's tags are there.
struct OsmPlaceRule {
  PlaceKind kind{};
  std::array<OsmTag, 2> tag{};  ///< The second may be empty.
};

/// A kind that answers a wider one stands before it.
inline constexpr std::array osm_place_rules{
    OsmPlaceRule{PlaceKind::AccessibleToilets, {{{"amenity", "toilets"}, {"wheelchair", "yes"}}}},
    OsmPlaceRule{PlaceKind::AccessibleToilets,
                 {{{"amenity", "toilets"}, {"toilets:wheelchair", "yes"}}}},
    OsmPlaceRule{PlaceKind::AccessibleToilets, {{{"room", "toilet"}, {"wheelchair", "yes"}}}},
    OsmPlaceRule{PlaceKind::AccessibleToilets, {{{"room", "toilets"}, {"wheelchair", "yes"}}}},
    OsmPlaceRule{PlaceKind::AllGenderToilets, {{{"amenity", "toilets"}, {"unisex", "yes"}}}},
    OsmPlaceRule{PlaceKind::AllGenderToilets,
                 {{{"amenity", "toilets"}, {"gender_segregated", "no"}}}},
    OsmPlaceRule{PlaceKind::WomensToilets, {{{"amenity", "toilets"}, {"female", "yes"}}}},
    OsmPlaceRule{PlaceKind::MensToilets, {{{"amenity", "toilets"}, {"male", "yes"}}}},
    OsmPlaceRule{PlaceKind::Toilets, {{{"amenity", "toilets"}, {}}}},
    OsmPlaceRule{PlaceKind::Toilets, {{{"room", "toilet"}, {}}}},
    OsmPlaceRule{PlaceKind::Toilets, {{{"room", "toilets"}, {}}}},
    OsmPlaceRule{PlaceKind::BabyChange, {{{"changing_table", "yes"}, {}}}},
    OsmPlaceRule{PlaceKind::BabyChange, {{{"diaper", "yes"}, {}}}},
    OsmPlaceRule{PlaceKind::EmergencyExit, {{{"entrance", "emergency"}, {}}}},
    OsmPlaceRule{PlaceKind::EmergencyExit, {{{"exit", "emergency"}, {}}}},
    OsmPlaceRule{PlaceKind::Exit, {{{"entrance", "exit"}, {}}}},
    OsmPlaceRule{PlaceKind::Entrance, {{{"entrance", "main"}, {}}}},
    OsmPlaceRule{PlaceKind::Entrance, {{{"entrance", "yes"}, {}}}},
    OsmPlaceRule{PlaceKind::Entrance, {{{"entrance", "entrance"}, {}}}},
    OsmPlaceRule{PlaceKind::Information, {{{"tourism", "information"}, {}}}},
    OsmPlaceRule{PlaceKind::Information, {{{"amenity", "reception_desk"}, {}}}},
    OsmPlaceRule{PlaceKind::Information, {{{"room", "reception"}, {}}}},
    OsmPlaceRule{PlaceKind::Tickets, {{{"shop", "ticket"}, {}}}},
    OsmPlaceRule{PlaceKind::Tickets, {{{"amenity", "ticket_validator"}, {}}}},
    OsmPlaceRule{PlaceKind::Tickets, {{{"vending", "admission_tickets"}, {}}}},
    OsmPlaceRule{PlaceKind::Cloakroom, {{{"amenity", "cloakroom"}, {}}}},
    OsmPlaceRule{PlaceKind::Cloakroom, {{{"room", "cloakroom"}, {}}}},
    OsmPlaceRule{PlaceKind::Lockers, {{{"amenity", "locker"}, {}}}},
    OsmPlaceRule{PlaceKind::Lockers, {{{"amenity", "luggage_locker"}, {}}}},
    OsmPlaceRule{PlaceKind::Lockers, {{{"room", "locker"}, {}}}},
    OsmPlaceRule{PlaceKind::Cafe, {{{"amenity", "cafe"}, {}}}},
    OsmPlaceRule{PlaceKind::Cafe, {{{"amenity", "bar"}, {}}}},
    OsmPlaceRule{PlaceKind::Restaurant, {{{"amenity", "restaurant"}, {}}}},
    OsmPlaceRule{PlaceKind::Restaurant, {{{"amenity", "fast_food"}, {}}}},
    OsmPlaceRule{PlaceKind::Restaurant, {{{"amenity", "food_court"}, {}}}},
    OsmPlaceRule{PlaceKind::Lift, {{{"highway", "elevator"}, {}}}},
    OsmPlaceRule{PlaceKind::Lift, {{{"room", "elevator"}, {}}}},
    OsmPlaceRule{PlaceKind::Stairs, {{{"highway", "steps"}, {}}}},
    OsmPlaceRule{PlaceKind::Stairs, {{{"room", "stairs"}, {}}}},
    OsmPlaceRule{PlaceKind::Seat, {{{"amenity", "bench"}, {}}}},
    OsmPlaceRule{PlaceKind::Seat, {{{"amenity", "lounge"}, {}}}},
    OsmPlaceRule{PlaceKind::Water, {{{"amenity", "drinking_water"}, {}}}},
    OsmPlaceRule{PlaceKind::Water, {{{"drinking_water", "yes"}, {}}}},
    OsmPlaceRule{PlaceKind::FirstAid, {{{"emergency", "first_aid"}, {}}}},
    OsmPlaceRule{PlaceKind::FirstAid, {{{"emergency", "first_aid_kit"}, {}}}},
    OsmPlaceRule{PlaceKind::FirstAid, {{{"room", "first_aid"}, {}}}},
    OsmPlaceRule{PlaceKind::Defibrillator, {{{"emergency", "defibrillator"}, {}}}},
    OsmPlaceRule{PlaceKind::QuietRoom, {{{"amenity", "quiet_room"}, {}}}},
    OsmPlaceRule{PlaceKind::QuietRoom, {{{"room", "quiet"}, {}}}},
    OsmPlaceRule{PlaceKind::PrayerRoom, {{{"amenity", "place_of_worship"}, {}}}},
    OsmPlaceRule{PlaceKind::PrayerRoom, {{{"room", "prayer"}, {}}}},
    OsmPlaceRule{PlaceKind::MeetingPoint, {{{"highway", "meeting_point"}, {}}}},
    OsmPlaceRule{PlaceKind::LostAndFound, {{{"amenity", "lost_property_office"}, {}}}},
    OsmPlaceRule{PlaceKind::LostAndFound, {{{"amenity", "lost_property"}, {}}}},
    OsmPlaceRule{PlaceKind::CashMachine, {{{"amenity", "atm"}, {}}}},
    OsmPlaceRule{PlaceKind::Telephone, {{{"amenity", "telephone"}, {}}}},
    OsmPlaceRule{PlaceKind::Library, {{{"amenity", "library"}, {}}}},
    OsmPlaceRule{PlaceKind::Auditorium, {{{"amenity", "theatre"}, {}}}},
    OsmPlaceRule{PlaceKind::Auditorium, {{{"amenity", "cinema"}, {}}}},
    OsmPlaceRule{PlaceKind::Auditorium, {{{"room", "auditorium"}, {}}}},
    OsmPlaceRule{PlaceKind::Parking, {{{"amenity", "parking"}, {}}}},
    OsmPlaceRule{PlaceKind::Shop, {{{"shop", "*"}, {}}}},
};

/// What a thing with these tags is, each kind once: a toilet with a changing table is two. `value`:
/// of a key, empty where it has none. A kind that another of them answers as well is left out.
std::vector<PlaceKind> place_kinds_of_osm(auto&& value) {
  std::vector<PlaceKind> kinds;
  const auto has = [&](const OsmTag& tag) {
    const std::string_view written = value(tag.key);
    return tag.value == "*" ? !written.empty() && written != "no" : written == tag.value;
  };
  for (const OsmPlaceRule& rule : osm_place_rules) {
    if (!has(rule.tag[0]) || (!rule.tag[1].key.empty() && !has(rule.tag[1]))) continue;
    if (std::ranges::none_of(kinds, [&](PlaceKind kind) { return answers(kind, rule.kind); }))
      kinds.push_back(rule.kind);
  }
  // Any shop is last in the table: tickets are sold by one too.
  if (kinds.size() > 1 && kinds.back() == PlaceKind::Shop) kinds.pop_back();
  return kinds;
}

}  // namespace docent
