#include "tests/support/made_font.h"

#include <array>
#include <utility>
#include <vector>

namespace docent::test {
namespace {

constexpr std::uint16_t em = 1000, ascent = 800, weight = 400;
constexpr std::int16_t descent = -200;

/// Numbers as OpenType has them: the high byte first.
class Table {
 public:
  Table& u16(std::uint16_t value) {
    bytes += static_cast<char>(value >> 8U);
    bytes += static_cast<char>(value & 0xFFU);
    return *this;
  }
  Table& i16(int value) { return u16(static_cast<std::uint16_t>(value)); }
  Table& u32(std::uint32_t value) {
    return u16(static_cast<std::uint16_t>(value >> 16U)).u16(static_cast<std::uint16_t>(value));
  }
  Table& zeros(std::size_t count) {
    bytes.append(count, '\0');
    return *this;
  }

  std::string bytes;
};

std::string box() {
  Table glyph;
  glyph.i16(1).i16(20).i16(descent).i16(em - 20).i16(ascent);  // one contour, and its extent
  glyph.u16(3).u16(0);                                         // its last point; no instructions
  glyph.bytes.append(4, '\x01');                               // four points on the curve
  glyph.i16(20).i16(0).i16(em - 40).i16(0);
  glyph.i16(descent).i16(ascent - descent).i16(0).i16(descent - ascent);
  return glyph.zeros(2).bytes;
}

std::string cmap(const std::u32string& letters) {
  const auto groups = static_cast<std::uint32_t>(letters.size());
  Table table;
  table.u16(0).u16(1).u16(3).u16(10).u32(12);
  table.u16(12).u16(0).u32(16 + 12 * groups).u32(0).u32(groups);
  for (std::uint32_t i = 0; i < groups; ++i) table.u32(letters[i]).u32(letters[i]).u32(i + 1);
  return table.bytes;
}

std::string name(const std::string& family) {
  const std::array<std::pair<std::uint16_t, std::string>, 3> names{
      {{1, family}, {2, "Regular"}, {4, family}}};
  Table table, letters;
  table.u16(0).u16(names.size()).u16(6 + 12 * names.size());
  for (const auto& [id, text] : names) {
    table.u16(3).u16(1).u16(0x409).u16(id);
    table.u16(static_cast<std::uint16_t>(2 * text.size()));
    table.u16(static_cast<std::uint16_t>(letters.bytes.size()));
    for (const char letter : text) letters.u16(static_cast<unsigned char>(letter));
  }
  return table.bytes + letters.bytes;
}

std::string head() {
  Table table;
  table.u32(0x00010000).u32(0x00010000).u32(0).u32(0x5F0F3CF5).u16(3).u16(em).zeros(16);
  return table.i16(0).i16(descent).i16(em).i16(ascent).u16(0).u16(8).i16(2).i16(1).i16(0).bytes;
}

std::string hhea(std::uint16_t glyphs) {
  Table table;
  table.u32(0x00010000).i16(ascent).i16(descent).i16(0).u16(em).i16(0).i16(0).i16(em);
  return table.i16(1).zeros(14).u16(glyphs).bytes;
}

std::string maxp(std::uint16_t glyphs) {
  return Table().u32(0x00010000).u16(glyphs).u16(4).u16(1).zeros(4).u16(2).zeros(16).bytes;
}

std::string os2(std::uint16_t embedding) {
  Table table;
  table.u16(4).i16(em).u16(weight).u16(5).u16(embedding).zeros(58);
  table.i16(ascent).i16(descent).i16(0).u16(ascent).u16(-descent).zeros(8).i16(500).i16(ascent);
  return table.zeros(6).bytes;
}

}  // namespace

std::u32string latin_letters() {
  std::u32string letters;
  for (char32_t letter = U' '; letter <= U'~'; ++letter) letters += letter;
  return letters;
}

std::string make_font(const FontSketch& sketch) {
  const auto glyphs = static_cast<std::uint16_t>(sketch.letters.size() + 1);
  Table widths, places;
  std::string outlines;
  for (std::uint16_t i = 0; i < glyphs; ++i) {
    widths.u16(em).i16(20);
    places.u32(static_cast<std::uint32_t>(outlines.size()));
    outlines += box();
  }
  places.u32(static_cast<std::uint32_t>(outlines.size()));
  const std::vector<std::pair<std::string, std::string>> tables{
      {"OS/2", os2(sketch.embedding)},
      {"cmap", cmap(sketch.letters)},
      {"glyf", outlines},
      {"head", head()},
      {"hhea", hhea(glyphs)},
      {"hmtx", widths.bytes},
      {"loca", places.bytes},
      {"maxp", maxp(glyphs)},
      {"name", name(sketch.family)},
      {"post", Table().u32(0x00030000).zeros(28).bytes}};
  Table font;
  font.u32(0x00010000).u16(static_cast<std::uint16_t>(tables.size())).zeros(6);
  std::string body;
  const std::size_t first = 12 + 16 * tables.size();
  for (const auto& [tag, bytes] : tables) {
    font.bytes += tag;
    font.u32(0).u32(static_cast<std::uint32_t>(first + body.size()));
    font.u32(static_cast<std::uint32_t>(bytes.size()));
    body += bytes;
    body.append((4 - body.size() % 4) % 4, '\0');
  }
  return font.bytes + body;
}

}  // namespace docent::test
