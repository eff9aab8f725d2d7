#pragma once

#include <string>

#include "tests/support/museum_folder.h"

namespace docent::test {

/// A museum of two floors, 12 by 8 m each: stairs in the west, a lift in the east; a vase below and
/// a sword above.
class HouseFolder : public MuseumFolder {
 public:
  HouseFolder() {
    write("museum.toml",
          "[museum]\n"
          "title.en = \"House\"\n"
          "languages = [\"en\"]\n"
          "[[floor]]\n"
          "name = \"ground\"\n"
          "short = \"G\"\n"
          "title.en = \"Ground floor\"\n"
          "plan = \"hall.geojson\"\n"
          "[[floor]]\n"
          "name = \"upper\"\n"
          "height = 5\n"
          "plan = \"hall.geojson\"\n"
          "[kiosk]\n"
          "position = [2.0, 2.0]\n"
          "[[connection]]\n"
          "id = \"stairs\"\n"
          "kind = \"stairs\"\n"
          "stops = [{floor = \"ground\", position = [1, 4], facing = 180},\n"
          "  {floor = \"upper\", position = [1, 4]}]\n"
          "[[connection]]\n"
          "id = \"lift\"\n"
          "kind = \"lift\"\n"
          "stops = [{floor = \"upper\", position = [11, 4]}, {floor = \"ground\", position = [11, "
          "4]}]\n");
    write(
        "hall.geojson",
        "{\"type\": \"Polygon\", \"coordinates\": [[[0, 0], [12, 0], [12, 8], [0, 8], [0, 0]]]}\n");
    write("exhibits/hall.toml",
          "[[exhibit]]\n"
          "id = \"vase\"\n"
          "position = [6, 7]\n"
          "view = [6, 4]\n"
          "facing = 270\n"
          "title.en = \"Vase\"\n"
          "[[exhibit]]\n"
          "id = \"sword\"\n"
          "floor = \"upper\"\n"
          "position = [6, 7]\n"
          "view = [6, 4]\n"
          "facing = 270\n"
          "title.en = \"Sword\"\n");
  }
};

}  // namespace docent::test
