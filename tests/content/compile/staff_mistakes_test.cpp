// The mistakes that new staff make, each with what they are told: a file, a line and a column, a
// sentence of ours, and what to do. A row is a mistake; add one when somebody makes another.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "platform/image/image.h"
#include "tests/support/museum_folder.h"
#include "tests/support/wide_text.h"

namespace docent::compile::staff_mistakes_test {
namespace {

namespace fs = std::filesystem;
using test::MuseumFolder;
using test::ProgramRun;

constexpr const char* exhibits = "exhibits/hall.toml";
constexpr const char* plan = "ground.geojson";

struct Mistake {
  const char* name;
  std::function<void(const MuseumFolder&)> make;
  int exit_code;
  std::vector<const char*> told;
};

void PrintTo(const Mistake& mistake, std::ostream* out) {
  *out << mistake.name;
}

/// Replaces a text in a file.
auto changes(const char* file, std::string old, std::string with) {
  return [=](const MuseumFolder& museum) { museum.replace(file, old, with); };
}
/// Writes a file whole.
auto writes(const char* file, std::string text) {
  return [=](const MuseumFolder& museum) { museum.write(file, text); };
}
/// Gives the first exhibit another picture, of these bytes.
auto picture(const char* name, std::string bytes) {
  return [=](const MuseumFolder& museum) {
    museum.write(std::string("images/") + name, bytes);
    museum.replace(exhibits, "images/disc.svg", std::string("images/") + name);
  };
}

std::string png(std::uint32_t side) {
  const Pixels pixels{.width = side,
                      .height = side,
                      .rgba = std::vector<std::byte>(std::size_t{4} * side * side, std::byte{200})};
  const auto bytes = *image::encode_png(pixels);
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}
std::string jpeg() {
  const auto bytes = *image::encode_jpeg(
      {.width = 16, .height = 16, .rgba = std::vector<std::byte>(1024, std::byte{255})});
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

const std::vector<Mistake>& mistakes() {
  using namespace std::string_literals;
  static const std::vector<Mistake> all{
      // The folder of exhibits, and what lies in it.
      {"AnEmptyExhibitsFolder",
       [](const MuseumFolder& m) { fs::remove(m.path() / exhibits); },
       0,
       {"exhibits: warning[no-exhibits]: there are no exhibits", "hint: write a [[exhibit]]"}},
      {"NoExhibitsFolder",
       [](const MuseumFolder& m) { fs::remove_all(m.path() / "exhibits"); },
       0,
       {"exhibits: warning[no-exhibits]: there are no exhibits"}},
      {"AnExhibitsFolderThatIsAFile",
       [](const MuseumFolder& m) {
         fs::remove_all(m.path() / "exhibits");
         m.write("exhibits", "[[exhibit]]\n");
       },
       1,
       {"exhibits: error[bad-path]: is a file, and should be a folder of .toml files",
        "hint: make a folder exhibits"}},
      {"AFileOfExhibitsThatEndsInTxt",
       [](const MuseumFolder& m) {
         fs::rename(m.path() / exhibits, m.path() / "exhibits/hall.toml.txt");
       },
       0,
       {"hall.toml.txt: warning[not-read]: is not read: its name does not end in .toml",
        "hint: call it hall.toml"}},
      {"AFileOfExhibitsInCapitals",
       [](const MuseumFolder& m) {
         fs::rename(m.path() / exhibits, m.path() / "exhibits/HALL.TOML");
       },
       0,
       {"HALL.TOML: warning[not-read]", "hint: call it HALL.toml"}},
      {"AFolderWithinExhibits",
       [](const MuseumFolder& m) { m.write("exhibits/east/new.toml", "[[exhibit]]\n"); },
       0,
       {"east: warning[not-read]: is a folder, and what is in it is not read",
        "hint: move its files"}},
      {"AnEmptyFileOfExhibits",
       writes("exhibits/new.toml", ""),
       0,
       {"new.toml: warning[empty-file]: holds no exhibit"}},
      {"AMuseumTomlThatIsMissing",
       [](const MuseumFolder& m) { fs::remove(m.path() / "museum.toml"); },
       1,
       {"museum.toml: error[missing-file]: there is no file 'museum.toml'",
        "hint: it is looked for in"}},
      {"AMuseumTomlThatIsEmpty",
       writes("museum.toml", ""),
       1,
       {"museum.toml:1:1: error[missing-field]: museum.toml lacks a [[floor]]", "hint:"}},
      {"AnExhibitTableWithOneBracket",
       changes(exhibits, "[[exhibit]]\nid = \"portrait\"", "[exhibit]\nid = \"portrait\""),
       1,
       {"hall.toml:11:1: error[unreadable-toml]: '[exhibit]' is written twice",
        "write [[exhibit]]"}},
      {"ExhibitsWithOneBracket",
       writes("exhibits/new.toml", "[exhibit]\nid = \"new\"\n"),
       1,
       {"new.toml:1:1: error[wrong-type]", "written [[exhibit]], once for each"}},
      {"ExhibitsInTheMuseumToml",
       changes("museum.toml", "[[room]]", "[[exhibit]]\nid = \"x\"\n[[room]]"),
       1,
       {"museum.toml:13:3: error[unknown-key]: museum.toml has no 'exhibit'", "exhibits/"}},

      // How TOML is written.
      {"AnUnclosedText",
       changes(exhibits, "\"Jade disc\"", "\"Jade disc"),
       1,
       {"hall.toml:6:12: error[unreadable-toml]: the text that begins here is not closed",
        "hint: end it with a quotation mark"}},
      {"AnUnclosedLongText",
       changes(exhibits, "\"A disc.\"", "\"\"\"A disc."),
       1,
       {"hall.toml:8:11: error[unreadable-toml]: the text of several lines that begins here is "
        "never"}},
      {"SmartQuotes",
       changes(exhibits, "\"Jade disc\"", "“Jade disc”"),
       1,
       {"hall.toml:6:12: error[unreadable-toml]: “ is a word processor's quotation mark",
        "hint: write straight ones"}},
      {"ASmartQuoteAtTheEnd",
       changes(exhibits, "\"Jade disc\"", "\"Jade disc”"),
       1,
       {"hall.toml:6:22: error[unreadable-toml]: ” is a word processor's quotation mark"}},
      {"ATextWithoutQuotes",
       changes(exhibits, "\"Jade disc\"", "Jade disc"),
       1,
       {"hall.toml:6:12: error[unreadable-toml]: this text is not in quotation marks",
        "hint: write title.en = \"Jade disc\""}},
      {"AColonForAnEqualsSign",
       changes(exhibits, "facing = 270", "facing: 270"),
       1,
       {"hall.toml:4:7: error[unreadable-toml]: a colon stands where an equals sign belongs"}},
      {"AKeyWithoutAValue",
       changes(exhibits, "facing = 270", "facing ="),
       1,
       {"hall.toml:4:8: error[unreadable-toml]: 'facing' has no value"}},
      {"AKeyWithABlank",
       changes(exhibits, "facing = 270", "facing to = 270"),
       1,
       {"hall.toml:4:1: error[unreadable-toml]: 'facing to' cannot be a key: it holds a blank"}},
      {"AKeyWithAnAccent",
       changes(exhibits, "facing = 270", "façade = 270"),
       1,
       {"hall.toml:4:1: error[unreadable-toml]: 'façade' cannot be a key: it holds 'ç'"}},
      {"TwoThingsInALine",
       changes(exhibits, "facing = 270\n", "facing = 270 "),
       1,
       {"hall.toml:4:14: error[unreadable-toml]", "is one thing too many in this line"}},
      {"AUnitBehindANumber",
       changes(exhibits, "facing = 270", "facing = 270 degrees"),
       1,
       {"hall.toml:4:14: error[unreadable-toml]: 'degrees' is one thing too many in this line"}},
      {"AKeyWrittenTwice",
       changes(exhibits, "facing = 270", "facing = 270\nfacing = 90"),
       1,
       {"hall.toml:5:1: error[unreadable-toml]: 'facing' is written twice",
        "hint: the first is in line 4"}},
      {"ASectionWrittenTwice",
       changes("museum.toml", "[ambient]", "[museum]"),
       1,
       {"museum.toml:11:1: error[unreadable-toml]: '[museum]' is written twice",
        "the first is in line 1"}},
      {"AnUnclosedHeading",
       changes(exhibits, "[[exhibit]]", "[[exhibit]"),
       1,
       {"hall.toml:1:1: error[unreadable-toml]", "[[exhibit]]"}},
      {"AnUnclosedList",
       changes(exhibits, "[6.5, 4.5]", "[6.5, 4.5"),
       1,
       {"hall.toml:3:12: error[unreadable-toml]: the list that begins here is not closed"}},
      {"AMissingCommaInAList",
       changes(exhibits, "[6.5, 4.5]", "[6.5 4.5]"),
       1,
       {"hall.toml:3:17: error[unreadable-toml]", "a comma between them"}},
      {"ALineOfText",
       changes(exhibits, "facing = 270", "facing = 270\nnew since March"),
       1,
       {"hall.toml:5:1: error[unreadable-toml]: this line is neither key = value nor a heading",
        "a remark begins with #"}},
      {"YesForTrue",
       changes("museum.toml", "[[room]]",
               "[[door]]\nname = \"d\"\na = [0, 3]\nb = [0, 4]\nclosed = yes\n[[room]]"),
       1,
       {"museum.toml:17:10: error[unreadable-toml]: 'yes' is not how yes is written",
        "hint: write true"}},
      {"ATextForTrue",
       changes("museum.toml", "[[room]]",
               "[[door]]\nname = \"d\"\na = [0, 3]\nb = [0, 4]\nclosed = \"yes\"\n[[room]]"),
       1,
       {"museum.toml:17:10: error[wrong-type]: 'closed' should be true or false", "hint: "}},
      {"ABackslashInAText",
       changes(exhibits, "images/disc.svg", "images\\disc.svg"),
       1,
       {"hall.toml:5:16: error[unreadable-toml]: a backslash begins a special letter, and '\\d' is "
        "none",
        "hint: write folders with a slash"}},
      {"ABackslashThatIsATab",
       changes(exhibits, "images/disc.svg", "images\\tisc.svg"),
       1,
       {"hall.toml:5:9: error[bad-path]: a file's name holds a backslash, or what a backslash made "
        "of it"}},
      {"WindowsLineEnds",
       changes(exhibits, "facing = 270\n", "facing = \r\n"),
       1,
       {"hall.toml:4:8: error[unreadable-toml]: 'facing' has no value"}},

      // Encodings.
      {"Windows1252",
       changes(exhibits, "Jade disc", "Caf\xe9"),
       1,
       {"hall.toml:6:16: error[unreadable-toml]: is not UTF-8 but, it seems, Windows-1252",
        "is 'é' in it", "hint: save the file again as UTF-8"}},
      {"WindowsQuotes",
       changes(exhibits, "Jade disc", "\x93Jade\x94"),
       1,
       {"hall.toml:6:13: error[unreadable-toml]: is not UTF-8 but, it seems, Windows-1252: the "
        "byte "
        "0x93 here is '“'"}},
      {"Utf16",
       [](const MuseumFolder& m) {
         m.write(exhibits,
                 test::wide(U"\uFEFF[[exhibit]]\nid = \"x\"\n", 2, test::ByteOrder::Little));
       },
       1,
       {"hall.toml:1:1: error[unreadable-toml]: is UTF-16 (little endian), and only UTF-8 is read",
        "hint: save the file again as UTF-8"}},
      {"AWordProcessorsFile",
       writes(exhibits, "PK\3\4\0\0\0\0"s),
       1,
       {"hall.toml", "error[unreadable-toml]", "hint: "}},

      // Numbers and places.
      {"DecimalCommasInAPoint",
       changes(exhibits, "[6.5, 4.5]", "[6,5, 4,5]"),
       1,
       {"hall.toml:3:12: error[wrong-type]: 'position' should be a point",
        "decimals are written with a full stop: [6.5, 4.5]"}},
      {"ADecimalCommaInANumber",
       changes(exhibits, "facing = 270", "facing = 270,5"),
       1,
       {"hall.toml:4:10: error[unreadable-toml]: a comma stands in a number where a full stop "
        "belongs"}},
      {"APointOfOneNumber",
       changes(exhibits, "[6.5, 4.5]", "[6.5]"),
       1,
       {"hall.toml:3:12: error[wrong-type]: 'position' should be a point: [east, north] in "
        "metres"}},
      {"APointAsAText",
       changes(exhibits, "[6.5, 4.5]", "\"6.5, 4.5\""),
       1,
       {"hall.toml:3:12: error[wrong-type]", "this is a text", "hint: "}},
      {"ADirectionAsAText",
       changes(exhibits, "facing = 270", "facing = \"south\""),
       1,
       {"hall.toml:4:10: error[wrong-type]: 'facing' should be a number", "hint: "}},
      {"ADirectionOfTooManyDegrees",
       changes(exhibits, "facing = 270", "facing = 2700"),
       1,
       {"hall.toml:4:10: error[out-of-range]: 'facing' should be from -360 to 360", "hint: "}},
      {"AnExhibitWithoutAPosition",
       changes(exhibits, "position = [6.5, 4.5]\n", ""),
       1,
       {"hall.toml:1:1: error[missing-field]: [[exhibit]] lacks 'position'",
        "hint: write position = [12.5, 4.0]"}},
      {"APositionInMillimetres",
       changes(exhibits, "[6.5, 4.5]", "[6500, 4500]"),
       1,
       {"hall.toml:3:12: error[exhibit-outside-floor]", "hint: the nearest free point is"}},
      {"AnExhibitOutsideTheBuilding",
       changes(exhibits, "[6.5, 4.5]", "[-1, 4.5]"),
       1,
       {"hall.toml:3:12: error[exhibit-outside-floor]", "1.00 m outside", "hint: "}},
      {"TwoExhibitsOnOneSpot",
       changes(exhibits, "[10.0, 4.0]", "[6.5, 4.5]"),
       0,
       {"hall.toml:13:12: warning[same-spot]: the exhibits 'jade-disc' and 'portrait' stand on one "
        "spot",
        "hint: the first is at"}},
      {"AnExhibitInADoorway",
       [](const MuseumFolder& m) {
         m.replace("ground.geojson", "[[[12, 0]",
                   "[[[10, 1], [12, 1], [12, 2], [10, 2], [10, 1]]], [[[12, 0]");
         m.replace(exhibits, "[10.0, 4.0]", "[14.0, 4.0]");
         m.replace(exhibits, "facing = 180", "facing = 270");
         m.write("exhibits/b.toml",
                 "[[exhibit]]\nid = \"stele\"\nposition = [11, 1.5]\nfacing = 180\nimage = "
                 "\"images/disc.svg\"\ntitle.en = \"S\"\ntitle.ar = \"S\"\n");
       },
       1,
       {"b.toml:3:12: error[thing-in-the-way]: exhibit 'stele' closes the passage at [11.",
        "nobody can get past", "it takes 0.60 by 0.60 m of the floor, and the guide needs 0.50 m",
        "hint: move it, or write a smaller size; no visitor can get to 'portrait'"}},
      {"TwoExhibitsThatStandInEachOther",
       [](const MuseumFolder& m) {
         m.replace(exhibits, "[10.0, 4.0]", "[4.0, 4.0]");
         m.write("exhibits/new.toml",
                 "[[exhibit]]\nid = \"stele\"\nposition = [4.1, 4.5]\nfacing = 0\nimage = "
                 "\"images/disc.svg\"\ntitle.en = \"S\"\ntitle.ar = \"S\"\n");
       },
       0,
       {"new.toml:3:12: warning[things-overlap]: exhibit 'portrait' and exhibit 'stele' take the "
        "same "
        "0.10 m",
        "size = 0.6 is taken where none is said"}},
      {"AViewingPointInWhatIsLookedAt",
       [](const MuseumFolder& m) {
         m.replace(exhibits, "[10.0, 4.0]", "[4.0, 4.0]");
         m.replace(exhibits, "facing = 180", "facing = 180\nsize = 2\nview = [2.9, 4.0]");
       },
       1,
       {"hall.toml:16:8: error[exhibit-unreachable]: nobody can stand at the viewing point of "
        "exhibit 'portrait'",
        "0.10 m from exhibit 'portrait', which takes 2.00 by 2.00 m", "hint: the nearest point"}},
      {"AKioskInAnExhibit",
       [](const MuseumFolder& m) { m.replace(exhibits, "[10.0, 4.0]", "[2.1, 2.0]"); },
       1,
       {"error[kiosk-outside-floor]", "on the place of exhibit 'portrait', which takes 0.60"}},
      {"AnEntranceOfStrollersBesideAnExhibit",
       [](const MuseumFolder& m) {
         m.replace(exhibits, "[10.0, 4.0]", "[4.0, 4.0]");
         m.replace("museum.toml", "count = 3", "count = 3\nfrom = [4.4, 4.0]");
       },
       1,
       {"error[entrance-outside-floor]", "0.10 m from exhibit 'portrait', which takes 0.60 by"}},
      {"AStopInAnExhibit",
       [](const MuseumFolder& m) {
         m.replace(exhibits, "[10.0, 4.0]", "[4.0, 4.0]");
         m.replace("museum.toml", "[kiosk]",
                   "title.en = \"G\"\n[[floor]]\nname = \"upper\"\ntitle.en = \"U\"\nplan = "
                   "\"up.geojson\"\n[[connection]]\nid = \"lift\"\nkind = \"lift\"\nstops = "
                   "[{floor = \"ground\", position = [4.0, 4.1]}, {floor = \"upper\", position = "
                   "[4.0, 4.1]}]\n[kiosk]");
         m.write("up.geojson", test::text_of(m.path() / "ground.geojson"));
       },
       1,
       {"error[connection-outside-floor]", "on the place of exhibit 'portrait'"}},
      {"ACaseOutsideTheFloor",
       changes("museum.toml", "[[room]]",
               "[[case]]\nid = \"c\"\nposition = [11, 6]\nsize = 1\n[[room]]"),
       1,
       {"error[case-outside-floor]: case 'c' stands outside the floor of 'ground'"}},
      {"AnUnknownFloor",
       changes(exhibits, "facing = 270", "facing = 270\nfloor = \"first\""),
       1,
       {"hall.toml:5:9: error[unknown-floor]: there is no floor 'first'",
        "hint: the floors are: ground"}},
      {"AMisspeltKey",
       changes(exhibits, "facing = 270", "faceing = 270"),
       1,
       {"hall.toml:4:1: error[unknown-key]: [[exhibit]] has no 'faceing'",
        "hint: did you mean 'facing'?"}},
      {"ACapitalInAKey",
       changes(exhibits, "facing = 270", "Facing = 270"),
       1,
       {"hall.toml:4:1: error[unknown-key]: [[exhibit]] has no 'Facing'",
        "hint: did you mean 'facing'?"}},
      {"AnIdWithBlanks",
       changes(exhibits, "\"portrait\"", "\"my portrait\""),
       1,
       {"hall.toml:12:6: error[bad-value]", "hint: use letters, digits and hyphens"}},
      {"AnEmptyId",
       changes(exhibits, "\"portrait\"", "\"\""),
       1,
       {"hall.toml:12:6: error[bad-value]"}},
      {"ANumberForAnId",
       changes(exhibits, "\"portrait\"", "12"),
       1,
       {"hall.toml:12:6: error[wrong-type]: 'id' should be a text in quotation marks", "hint: "}},
      {"TwoExhibitsWithOneId",
       changes(exhibits, "\"portrait\"", "\"jade-disc\""),
       1,
       {"hall.toml:12:6: error[duplicate-id]", "hint: the first is at"}},

      // Rooms, doors, the kiosk.
      {"ARoomElsewhere",
       changes("museum.toml", "[[0, 0], [10, 0], [10, 8], [0, 8]]",
               "[[100, 0], [110, 0], [110, 8], [100, 8]]"),
       1,
       {"museum.toml:18:11: error[room-outside-floor]: the outline of room 'hall' lies elsewhere",
        "hint: "}},
      {"ARoomOfTwoCorners",
       changes("museum.toml", "[[0, 0], [10, 0], [10, 8], [0, 8]]", "[[0, 0], [10, 0]]"),
       1,
       {"museum.toml:18:11: error[bad-value]: the outline of room 'hall' holds no area", "hint: "}},
      {"ARoomsNameOutside",
       changes("museum.toml", "label = [5.0, 4.0]", "label = [50, 40]"),
       0,
       {"museum.toml:17:9: warning[label-outside-floor]: the name of room 'hall' would stand "
        "outside"}},
      {"ADoorAcrossOpenFloor",
       changes("museum.toml", "[[room]]",
               "[[door]]\nname = \"d\"\na = [3, 3]\nb = [4, 3]\n[[room]]"),
       0,
       {"museum.toml:15:5: warning[door-in-the-open]: door 'd' stands in the open floor",
        "3.00 m from any wall", "hint: let both ends"}},
      {"ADoorOutside",
       changes("museum.toml", "[[room]]",
               "[[door]]\nname = \"d\"\na = [30, 3]\nb = [31, 3]\n[[room]]"),
       1,
       {"museum.toml:15:5: error[door-outside-floor]", "hint: "}},
      {"ADoorWithoutAName",
       changes("museum.toml", "[[room]]", "[[door]]\na = [3, 3]\nb = [4, 3]\n[[room]]"),
       1,
       {"museum.toml:13:1: error[missing-field]", "hint: write id = "}},
      {"AKioskOutside",
       changes("museum.toml", "position = [2.0, 2.0]", "position = [200, 200]"),
       1,
       {"museum.toml:9:12: error[kiosk-outside-floor]", "hint: "}},

      // Pictures.
      {"AnExhibitWithoutAPicture",
       changes(exhibits, "image = \"images/disc.svg\"\n", ""),
       0,
       {"hall.toml:1:1: warning[no-picture]: exhibit 'jade-disc' has no picture", "hint: image ="}},
      {"APictureThatIsAFolder",
       changes(exhibits, "images/disc.svg", "images"),
       1,
       {"hall.toml:5:9: error[bad-path]: 'images' is a folder", "hint: name a file in it"}},
      {"AFurtherPictureThatIsMissing",
       changes(exhibits, "title.en = \"Jade disc\"",
               "pictures = [{image = \"images/dics.svg\"}]\ntitle.en = \"Jade disc\""),
       1,
       {"hall.toml:6:22: error[missing-file]", "hint: did you mean 'images/disc.svg'?"}},
      {"FurtherPicturesWithoutAFirst",
       changes(exhibits, "image = \"images/disc.svg\"\ntitle.en = \"Jade disc\"",
               "pictures = [{image = \"images/disc.svg\"}]\ntitle.en = \"Jade disc\""),
       1,
       {"hall.toml:5:12: error[missing-field]: exhibit 'jade-disc' has further pictures and no "
        "first one",
        "hint: write image = \"images/disc.svg\", and take it out of 'pictures'"}},
      {"MorePicturesThanOneLeafsThrough",
       [](const MuseumFolder& m) {
         std::string list;
         for (int i = 0; i < 20; ++i) list += "{image = \"images/disc.svg\"}, ";
         m.replace(exhibits, "title.en = \"Jade disc\"",
                   "pictures = [" + list + "]\ntitle.en = \"Jade disc\"");
       },
       1,
       {"hall.toml:6:12: error[out-of-range]: exhibit 'jade-disc' has 21 pictures, its own one "
        "included",
        "hint: visitors leaf through at most 20"}},
      {"PicturesAsAListOfFiles",
       changes(exhibits, "title.en = \"Jade disc\"",
               "pictures = [\"images/disc.svg\"]\ntitle.en = \"Jade disc\""),
       1,
       {"hall.toml:6:12: error[wrong-type]: 'pictures' should be a list of pictures: "
        "[{image = \"images/...\""}},
      {"ACaptionInOneLanguage",
       changes(exhibits, "title.en = \"Jade disc\"",
               "pictures = [{image = \"images/disc.svg\", caption.en = \"Back\"}]\ntitle.en = "
               "\"Jade disc\""),
       1,
       {"error[missing-translation]: the caption of picture 2 of exhibit 'jade-disc' is not "
        "translated into 'ar'"}},
      {"ALongerTextThatIsMissing",
       changes(exhibits, "text.ar = \"قرص.\"",
               "text.ar = \"قرص.\"\nmore.ar = \"المزيد\"\nmore_file.en = \"texts/disc.txt\""),
       1,
       {"hall.toml:11:16: error[missing-file]: there is no file 'texts/disc.txt'"}},
      {"ALongerTextTwice",
       [](const MuseumFolder& m) {
         m.write("texts/disc.txt", "It was found in a well.\n");
         m.replace(exhibits, "text.ar = \"قرص.\"",
                   "text.ar = \"قرص.\"\nmore.en = \"It was found.\"\nmore.ar = \"المزيد\"\n"
                   "more_file.en = \"texts/disc.txt\"");
       },
       1,
       {"error[bad-value]: exhibit 'jade-disc' has both more.en and more_file.en",
        "hint: keep one of them"}},
      {"ALongerTextThatIsNotUtf8",
       [](const MuseumFolder& m) {
         m.write("texts/disc.txt", "Found in a well.\nNear the caf\xe9.\n");
         m.replace(exhibits, "text.ar = \"قرص.\"",
                   "text.ar = \"قرص.\"\nmore.ar = \"المزيد\"\nmore_file.en = "
                   "\"texts/disc.txt\"");
       },
       1,
       {"hall.toml:11:16: error[not-utf8]: texts/disc.txt:2 ", "hint: "}},
      {"APictureThatIsMissing",
       changes(exhibits, "disc.svg", "dics.svg"),
       1,
       {"hall.toml:5:9: error[missing-file]: there is no file 'images/dics.svg'",
        "hint: did you mean 'images/disc.svg'?"}},
      {"APictureWithAnotherEnding",
       changes(exhibits, "disc.svg", "disc.png"),
       1,
       {"hall.toml:5:9: error[missing-file]", "hint: did you mean 'images/disc.svg'?"}},
      {"APictureInTheWrongCase",
       changes(exhibits, "images/disc.svg", "Images/Disc.SVG"),
       1,
       {"hall.toml:5:9: error[missing-file]", "capital letters matter",
        "hint: it is called 'images/disc.svg'"}},
      {"APictureOutside",
       [](const MuseumFolder& m) { m.replace(exhibits, "images/disc.svg", "../out.jpg"); },
       1,
       {"hall.toml:5:9: error[outside-museum]: '../out.jpg' leads out of the museum's folder",
        "hint: "}},
      {"AnAbsolutePath",
       changes(exhibits, "images/disc.svg", "/etc/passwd"),
       1,
       {"hall.toml:5:9: error[outside-museum]: '/etc/passwd' is an absolute path",
        "hint: copy the file"}},
      {"ADriveLetter",
       changes(exhibits, "images/disc.svg", "C:/Users/me/disc.svg"),
       1,
       {"hall.toml:5:9: error[outside-museum]: 'C:/Users/me/disc.svg' is an absolute path"}},
      {"AnAddressInTheWeb",
       changes(exhibits, "images/disc.svg", "https://example.org/disc.jpg"),
       1,
       {"hall.toml:5:9: error[outside-museum]", "is in the web", "hint: save it"}},
      {"ALinkThatLeadsOut",
       [](const MuseumFolder& m) {
         fs::create_symlink("/etc/passwd", m.path() / "images/link.svg");
         m.replace(exhibits, "disc.svg", "link.svg");
       },
       1,
       {"hall.toml:5:9: error[outside-museum]: 'images/link.svg' is a link that leads out"}},
      {"ALinkedFolderThatLeadsOut",
       [](const MuseumFolder& m) {
         fs::create_symlink("/etc", m.path() / "shared");
         m.replace(exhibits, "images/disc.svg", "shared/passwd");
       },
       1,
       {"hall.toml:5:9: error[outside-museum]"}},
      {"ALinkToNothing",
       [](const MuseumFolder& m) {
         fs::create_symlink("gone.svg", m.path() / "images/link.svg");
         m.replace(exhibits, "disc.svg", "link.svg");
       },
       1,
       {"hall.toml:5:9: error[missing-file]: 'images/link.svg' is a link to a file that is not "
        "there"}},
      {"AnEmptyPicture",
       picture("empty.png", ""),
       1,
       {"hall.toml:5:9: error[empty-file]: the file 'images/empty.png' is empty", "hint: "}},
      {"ATextCalledPng",
       picture("a.png", "hello"),
       1,
       {"hall.toml:5:9: error[unreadable-image]: 'images/a.png': this is no picture that can be "
        "read"}},
      {"APdfForAPicture",
       picture("a.pdf", "%PDF-1.4"),
       1,
       {"hall.toml:5:9: error[unreadable-image]: 'images/a.pdf': this is a PDF file",
        "hint: save the page"}},
      {"ATiff",
       picture("a.tif", "II*\0abcd"s),
       1,
       {"this is a TIFF picture", "hint: save it as PNG"}},
      {"ABmp", picture("a.bmp", "BM\x36\0\0\0\0\0\0\0\x36\0"s), 1, {"this is a BMP picture"}},
      {"APhotoshopFile", picture("a.psd", "8BPSxxxx"), 1, {"this is a Photoshop picture"}},
      {"AWebPageForAPicture",
       picture("a.jpg", "<!DOCTYPE html><html></html>"),
       1,
       {"this is a web page", "hint: download the file itself"}},
      {"APngCutShort",
       picture("a.png", png(40).substr(0, 60)),
       1,
       {"'images/a.png': this PNG is damaged or cut short", "hint: export it again"}},
      {"AJpegCutShort",
       picture("a.jpg", jpeg().substr(0, 200)),
       1,
       {"'images/a.jpg': this JPEG is damaged or cut short"}},
      {"AHeicCutShort",
       picture("a.heic",
               "\0\0\0\x18"
               "ftypheic\0\0\0\0"s),
       1,
       {"'images/a.heic': this HEIC or AVIF picture"}},
      {"AWebpCutShort",
       picture("a.webp", "RIFF\x10\0\0\0WEBPVP8 \0"s),
       1,
       {"'images/a.webp': this WebP picture is damaged or cut short"}},
      {"AGifCutShort",
       picture("a.gif", "GIF89a\x10\0"s),
       1,
       {"'images/a.gif': this GIF is damaged or cut short"}},
      {"AnSvgCutShort",
       picture("a.svg", "<svg xmlns='http://www.w3.org/2000/svg'>\n<rect"),
       1,
       {"'images/a.svg': this SVG drawing is damaged", "hint: "}},
      {"AnSvgWithALinkedPicture",
       picture("a.svg",
               "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 9 9'>"
               "<image href='photo.jpg' width='9' height='9'/></svg>"),
       0,
       {"hall.toml:5:9: warning[picture-dropped]: the drawing 'images/a.svg' links to the picture "
        "'photo.jpg', which is not shown",
        "hint: embed it"}},

      // Languages and texts.
      {"ALanguageInWords",
       changes("museum.toml", "[\"en\", \"ar\"]", "[\"english\", \"ar\"]"),
       1,
       {"museum.toml:4:14: error[unknown-language]: there is no language tag 'english'",
        "hint: did you mean \"en\"?"}},
      {"Klingon",
       changes("museum.toml", "[\"en\", \"ar\"]", "[\"en\", \"ar\", \"klingon\"]"),
       1,
       {"museum.toml:4:26: error[unknown-language]: there is no language tag 'klingon'", "hint: "}},
      {"ALanguageInCapitals",
       changes("museum.toml", "[\"en\", \"ar\"]", "[\"EN\", \"ar\"]"),
       1,
       {"museum.toml:4:14: error[unknown-language]: there is no language tag 'EN'",
        "hint: did you mean \"en\"?"}},
      {"ACountryForALanguage",
       changes("museum.toml", "[\"en\", \"ar\"]", "[\"en\", \"ar\", \"jp\"]"),
       1,
       {"there is no language tag 'jp'", "hint: did you mean \"ja\"?"}},
      {"AnUnderscoreInALanguage",
       changes("museum.toml", "\"ar\"]", "\"ar\", \"pt_br\"]"),
       1,
       {"there is no language tag 'pt_br'", "hint: did you mean \"pt-BR\"?"}},
      {"ALanguageTwice",
       changes("museum.toml", "[\"en\", \"ar\"]", "[\"en\", \"ar\", \"en\"]"),
       1,
       {"museum.toml:4:26: error[bad-value]: the language 'en' is written twice", "hint: "}},
      {"NoLanguages",
       changes("museum.toml", "[\"en\", \"ar\"]", "[]"),
       1,
       {"museum.toml:4:13: error[bad-value]: the museum speaks no language", "hint: "}},
      {"ALanguageWithoutWords",
       changes("museum.toml", "\"ar\"]", "\"ar\", \"fi\"]"),
       1,
       {"/words/fi.toml: error[missing-translation]: there are no words of the interface in 'fi'",
        "hint: "}},
      {"AMissingTranslation",
       changes(exhibits, "title.en = \"Portrait\"\n", ""),
       1,
       {"hall.toml:16:12: error[missing-translation]: the title of exhibit 'portrait' is not "
        "translated into 'en'",
        "here in 'ar'", "hint: translate from 'ar': صورة"}},
      {"ATextInACapitalLanguage",
       changes(exhibits, "title.en = \"Portrait\"", "title.EN = \"Portrait\""),
       1,
       {"hall.toml:16:7: error[unknown-language]: the title of exhibit 'portrait' is given in "
        "'EN', "
        "which is no language tag",
        "hint: did you mean 'en'?"}},
      {"ATitleWithoutALanguage",
       changes(exhibits, "title.en = \"Portrait\"\ntitle.ar = \"صورة\"\n",
               "title = \"Portrait\"\n"),
       1,
       {"hall.toml:16:9: error[wrong-type]: 'title' should be given by language: title.en",
        "hint: "}},
      {"AnExhibitWithoutATitle",
       changes(exhibits, "title.en = \"Portrait\"\ntitle.ar = \"صورة\"\n", ""),
       1,
       {"hall.toml:11:1: error[missing-field]: [[exhibit]] lacks 'title'",
        "hint: write title.en = "}},
      {"AnEmptyTitle",
       changes(exhibits, "\"Portrait\"", "\"  \""),
       1,
       {"hall.toml:16:12: error[empty-text]: the title of exhibit 'portrait' is empty in 'en'",
        "hint: "}},
      {"ATitleOf300Letters",
       changes(exhibits, "\"Portrait\"", "\"" + std::string(300, 'x') + "\""),
       0,
       {"hall.toml:16:12: warning[text-does-not-fit]: the title of exhibit 'portrait'", "in 'en'",
        "hint: "}},
      {"ATextOf3000Letters",
       [](const MuseumFolder& m) {
         std::string text;
         for (int i = 0; i < 600; ++i) text += "word ";
         m.replace(exhibits, "A disc.", text);
       },
       0,
       {"hall.toml:8:11: warning[text-does-not-fit]: the text of exhibit 'jade-disc'", "hint: "}},
      {"AnEmoji",
       changes(exhibits, "\"Portrait\"", "\"Portrait \xF0\x9F\x8E\x89\""),
       0,
       {"hall.toml:16:12: warning[unshown-letter]: the title of exhibit 'portrait' holds the emoji "
        "U+1F389",
        "hint: say it in words"}},
      {"APlaceholderOfAnotherName",
       [](const MuseumFolder& m) {
         m.write("words/en.toml", test::text_of(test::source_dir() / "config/words/en.toml"));
         m.write("words/ar.toml", test::text_of(test::source_dir() / "config/words/ar.toml"));
         m.replace("words/en.toml", "distance = \"{n} m\"", "distance = \"{m} m\"");
       },
       1,
       {"error[wrong-placeholder]: the word 'distance' holds {m}, which nothing fills in",
        "hint: in English it is: {n} m"}},
      {"AFileOfWordsThatEndsInTxt",
       [](const MuseumFolder& m) { m.write("words/fr.txt", "name"); },
       0,
       {"fr.txt: warning[not-read]", "hint: call it fr.toml"}},

      // Plans.
      {"APlanThatIsMissing",
       changes("museum.toml", "ground.geojson", "grond.geojson"),
       1,
       {"museum.toml:7:8: error[missing-file]", "hint: did you mean 'ground.geojson'?"}},
      {"ADxfForAPlan",
       writes(plan, "  0\nSECTION\n  2\nHEADER\n"),
       1,
       {"ground.geojson:1:1: error[not-geojson]: this is a DXF drawing",
        "hint: docent-content import"}},
      {"ADwgForAPlan",
       writes(plan, "AC1032\0\0"s),
       1,
       {"ground.geojson:1:1: error[not-geojson]: this is a DWG drawing", "hint: save it as DXF"}},
      {"AnIfcForAPlan",
       writes(plan, "ISO-10303-21;\nHEADER;"),
       1,
       {"this is an IFC building model", "hint: docent-content import"}},
      {"AnOsmFileForAPlan",
       writes(plan, "<?xml version='1.0'?>\n<osm version='0.6'></osm>"),
       1,
       {"this is an OpenStreetMap file", "hint: docent-content import"}},
      {"AnSvgForAPlan",
       writes(plan, "<svg xmlns='http://www.w3.org/2000/svg'/>"),
       1,
       {"this is an SVG drawing", "hint: "}},
      {"APdfForAPlan", writes(plan, "%PDF-1.7"), 1, {"this is a PDF file", "hint: "}},
      {"AZipForAPlan", writes(plan, "PK\3\4abc"), 1, {"this is a ZIP archive", "hint: "}},
      {"APhotoForAPlan", writes(plan, jpeg()), 1, {"this is a JPEG picture", "hint: "}},
      {"AShapefileForAPlan",
       writes(plan, "\0\0\x27\x0a\0\0\0\0"s),
       1,
       {"this is a shapefile", "hint: save the plan as GeoJSON"}},
      {"AnEmptyPlan",
       writes(plan, ""),
       1,
       {"error[empty-file]: the file 'ground.geojson' is empty"}},
      {"ATrailingComma",
       changes(plan, "[0, 0]],\n", "[0, 0]],],\n"),
       1,
       {"ground.geojson:3:", "error[unreadable-json]: a comma stands before the closing bracket"}},
      {"AMissingComma",
       changes(plan, "[10, 0], [10, 8]", "[10, 0] [10, 8]"),
       1,
       {"ground.geojson:3:20: error[unreadable-json]: a comma is missing in front of this"}},
      {"APlanCutShort",
       changes(plan, "]]]]}}", "]]"),
       1,
       {"error[unreadable-json]: the file ends too early: 4 brackets are still open"}},
      {"ADecimalCommaInOneNumberOfAPlan",
       changes(plan, "[10, 0]", "[10,2, 0.5]"),
       0,
       {"ground.geojson:3:12: warning[doubtful-height]: a point of 3 numbers among points of 2",
        "hint: if it is none: decimals are written with a full stop"}},
      {"DecimalCommasInAPlan",
       changes(plan, "[10, 8]", "[10,0, 8,0]"),
       1,
       {"ground.geojson:3:21: error[invalid-geojson]: a position of 4 numbers", "hint: decimals"}},
      {"ATextForACoordinate",
       changes(plan, "[10, 8]", "[\"10\", 8]"),
       1,
       {"error[invalid-geojson]: a coordinate must be a finite number", "hint: "}},
      {"TopoJson", writes(plan, "{\"type\": \"Topology\"}"), 1, {"hint: this is TopoJSON"}},
      {"SomeOtherJson",
       writes(plan, "{\"a\": 1}"),
       1,
       {"this object has no \"type\", so it is not GeoJSON",
        "hint: a floor is a FeatureCollection"}},
      {"APlanOfLines",
       writes(plan, "{\"type\": \"LineString\", \"coordinates\": [[0, 0], [1, 0]]}"),
       1,
       {"error[no-floor]", "hint: draw the walkable floor as areas"}},
      {"ADoorwayWithAGapOfACentimetre",
       [](const MuseumFolder& m) {
         m.replace(plan, " [[[12, 0]",
                   " [[[10, 1], [11.99, 1], [11.99, 3], [10, 3], [10, 1]]], [[[12, 0]");
         m.replace(exhibits, "[10.0, 4.0]", "[16.0, 2.0]");
       },
       1,
       {"ground.geojson:5:", "error[plan-gap]: there is a gap of 1 cm in the plan at",
        "no visitor can get to 'portrait'"}},
      {"ADanglingDoorway",
       changes(plan, " [[[12, 0]",
               " [[[10, 1], [10.4, 1], [10.4, 3], [10, 3], [10, 1]]], [[[12, 0]"),
       0,
       {"ground.geojson:5:",
        "warning[dangling-doorway]: the doorway about [10.20, 2.00] leads nowhere",
        "hint: draw it"}},
  };
  return all;
}

class StaffMistake : public testing::TestWithParam<Mistake> {};

TEST_P(StaffMistake, IsTold) {
  const Mistake& mistake = GetParam();
  const MuseumFolder museum;
  mistake.make(museum);

  const ProgramRun run = test::run_program(
      "docent-content", "check '" + museum.path().string() + "' --no-motion --quiet");

  EXPECT_EQ(run.exit_code, mistake.exit_code) << run.err;
  for (const char* told : mistake.told) EXPECT_THAT(run.err, testing::HasSubstr(told));
}

INSTANTIATE_TEST_SUITE_P(All, StaffMistake, testing::ValuesIn(mistakes()),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(StaffMistakes, AreEightyAndMore) {
  EXPECT_GE(mistakes().size(), 80U);
}

TEST(StaffMistakes, NoSentenceIsALibrarys) {
  for (const Mistake& mistake : mistakes()) {
    const MuseumFolder museum;
    mistake.make(museum);

    const std::string told =
        test::run_program("docent-content",
                          "check '" + museum.path().string() + "' --no-motion --quiet")
            .err;

    for (const char* theirs : {"Error while", "parse error", "json.exception", "Error domain",
                               "terminate called", "filesystem error", "basic_string"})
      EXPECT_THAT(told, testing::Not(testing::HasSubstr(theirs))) << mistake.name;
  }
}

TEST(StaffMistakes, FiveHundredAlikeBecomeOneWithACount) {
  const MuseumFolder museum;
  std::string many;
  for (int i = 0; i < 500; ++i)
    many += "[[exhibit]]\nid = \"x" + std::to_string(i) + "\"\nposition = [" +
            std::to_string(1 + 0.01 * i) +
            ", 1]\nfacing = 90\ntitle.en = \"X\"\ntitle.ar = \"X\"\n";
  museum.write("exhibits/many.toml", many);

  const ProgramRun run = test::run_program(
      "docent-content", "check '" + museum.path().string() + "' --no-motion --quiet");

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.err, testing::HasSubstr("and 497 more like this"));
  EXPECT_LT(std::ranges::count(run.err, '\n'), 40) << run.err;
}

TEST(StaffMistakes, ACompileSaysWhatItFoundAndWhatWasThereBefore) {
  const MuseumFolder museum;
  const auto compile = [&] {
    return test::run_program("docent-content", "compile '" + museum.path().string() + "' -o '" +
                                                   museum.database().string() + "' --no-motion");
  };

  EXPECT_THAT(compile().err, testing::HasSubstr("found 2 exhibits, 1 room, 0 doors, 1 floor"));
  museum.write("exhibits/new.toml",
               "[[exhibit]]\nid = \"new\"\nposition = [3, 3]\nfacing = 90\nimage = "
               "\"images/disc.svg\"\ntitle.en = \"N\"\ntitle.ar = \"N\"\n");
  EXPECT_THAT(compile().err, testing::HasSubstr("found 3 exhibits (2 before), 1 room, 0 doors"));
  museum.replace("museum.toml", "[[room]]",
                 "[[place]]\nid = \"seat\"\nkind = \"seat\"\nposition = [3, 6]\n[[room]]");
  EXPECT_THAT(compile().err, testing::HasSubstr("1 floor, 1 place (0 before), 0 connections"));
  EXPECT_THAT(compile().err, testing::HasSubstr("1 floor, 1 place, 0 connections"));
}

TEST(StaffMistakes, APictureOfAGifIsItsFirstFrame) {
  const MuseumFolder museum;
  // 1 x 1, red; a second, green frame follows.
  const std::string gif(
      "GIF89a\1\0\1\0\x80\0\0\xff\0\0\0\xff\0"
      ",\0\0\0\0\1\0\1\0\0\2\2\x44\1\0,\0\0\0\0\1\0\1\0\0\2\2\x4c\1\0;",
      49);
  museum.write("images/a.gif", gif);
  museum.replace(exhibits, "disc.svg", "a.gif");

  const ProgramRun run = museum.compile();

  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
}

TEST(StaffMistakes, AFloorWithoutATitleNeverShowsItsName) {
  const MuseumFolder museum;
  museum.replace("museum.toml", "name = \"ground\"", "name = \"level3\"");
  museum.replace("museum.toml",
                 test::text_of(museum.path() / "museum.toml")
                     .substr(test::text_of(museum.path() / "museum.toml").find("[[room]]")),
                 "");

  ASSERT_EQ(museum.compile().exit_code, 0);

  const std::string rooms =
      test::run_program("docent-content", "info '" + museum.database().string() + "'").out;
  EXPECT_THAT(rooms, testing::Not(testing::HasSubstr("level3")));
}

}  // namespace
}  // namespace docent::compile::staff_mistakes_test
