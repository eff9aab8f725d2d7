#pragma once

#include "tests/support/museum_folder.h"

namespace docent::test {

/// A hall of 12 by 8 m, parted by a wall with a door in the south and one in the north: the kiosk
/// in the west, a vase in the south-east.
class TwoDoorHall : public MuseumFolder {
 public:
  TwoDoorHall() {
    write("museum.toml",
          "[museum]\n"
          "title.en = \"Hall\"\n"
          "languages = [\"en\"]\n"
          "[[floor]]\n"
          "name = \"ground\"\n"
          "plan = \"hall.geojson\"\n"
          "[kiosk]\n"
          "position = [2, 2]\n"
          "[[room]]\n"
          "id = \"east\"\n"
          "title.en = \"East\"\n"
          "label = [10, 4]\n"
          "outline = [[8.2, 0], [12, 0], [12, 8], [8.2, 8]]\n"
          "[[door]]\n"
          "id = \"south\"\n"
          "a = [8.1, 1]\n"
          "b = [8.1, 2.4]\n"
          "[[door]]\n"
          "id = \"north\"\n"
          "a = [8.1, 5.6]\n"
          "b = [8.1, 7]\n");
    write("hall.geojson",
          R"({"type": "MultiPolygon", "coordinates": [
              [[[0, 0], [8, 0], [8, 8], [0, 8], [0, 0]]],
              [[[8.2, 0], [12, 0], [12, 8], [8.2, 8], [8.2, 0]]],
              [[[8, 1], [8.2, 1], [8.2, 2.4], [8, 2.4], [8, 1]]],
              [[[8, 5.6], [8.2, 5.6], [8.2, 7], [8, 7], [8, 5.6]]]]})");
    write("exhibits/hall.toml",
          "[[exhibit]]\n"
          "id = \"vase\"\n"
          "position = [11.5, 1.7]\n"
          "view = [10.5, 1.7]\n"
          "facing = 180\n"
          "title.en = \"Vase\"\n");
    write("images/disc.svg", "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 2 1'/>\n");
  }
};

}  // namespace docent::test
