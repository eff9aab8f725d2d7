#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace docent::import {

/// An object of a museum's collection, as its own catalogue tells of it. Texts are plain, UTF-8,
/// without blanks at their ends; what a catalogue lacks is empty and is never made up.
struct CollectionObject {
  std::string id;
  std::map<std::string, std::string, std::less<>> title, text;  ///< By language; "und": not said.
  std::string image;                                            ///< A file's name or an address.
  std::vector<std::string> subject;
  std::map<std::string, std::string, std::less<>> period;  ///< As text: "Ming, c. 1430".
  std::string file;                                        ///< Where it was read.
  std::uint32_t line = 0;                                  ///< Where it begins, from 1.
};

/// Something odd in a catalogue that was read nevertheless.
struct CollectionDoubt {
  std::string file;
  std::uint32_t line = 0;  ///< 0 where it is the whole file.
  std::string message;     ///< A sentence.
  std::string hint{};
};

struct Collection {
  std::vector<CollectionObject> objects;
  std::vector<std::string> members;  ///< Of a IIIF collection: the addresses of what it holds.
  std::vector<CollectionDoubt> doubts;
};

}  // namespace docent::import
