#include "content/import/gltf/accessor.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace docent::import::gltf {
namespace {

enum class Kind : std::uint32_t {
  Byte = 5120,
  UnsignedByte = 5121,
  Short = 5122,
  UnsignedShort = 5123,
  UnsignedInt = 5125,
  Float = 5126
};

std::size_t size_of(Kind kind) {
  switch (kind) {
    case Kind::Byte:
    case Kind::UnsignedByte:
      return 1;
    case Kind::Short:
    case Kind::UnsignedShort:
      return 2;
    case Kind::UnsignedInt:
    case Kind::Float:
      return 4;
  }
  return 4;
}

Kind kind_of(const Part& part) {
  const std::uint64_t number = part.whole(0, UINT32_MAX);
  for (const Kind kind : {Kind::Byte, Kind::UnsignedByte, Kind::Short, Kind::UnsignedShort,
                          Kind::UnsignedInt, Kind::Float})
    if (static_cast<std::uint64_t>(kind) == number) return kind;
  part.fail(fmt::format("is {}, which is no type of glTF", number));
}

std::size_t components_of(const Part& part) {
  const std::string type = part.text();
  for (const auto& [name, components] : {std::pair<std::string_view, std::size_t>{"SCALAR", 1},
                                         {"VEC2", 2},
                                         {"VEC3", 3},
                                         {"VEC4", 4},
                                         {"MAT4", 16}})
    if (type == name) return components;
  part.fail("is a type that is not read here");
}

template <typename Number>
Number number_at(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof(Number));  // little-endian, as the machine is
  return number;
}

double value_at(Kind kind, bool is_normalised, const char* bytes) {
  const double share = is_normalised ? 1 : 0;
  const auto scaled = [&](double value, double most) {
    return share > 0 ? std::max(value / most, -1.0) : value;
  };
  switch (kind) {
    case Kind::Byte:
      return scaled(number_at<std::int8_t>(bytes), 127);
    case Kind::UnsignedByte:
      return scaled(number_at<std::uint8_t>(bytes), 255);
    case Kind::Short:
      return scaled(number_at<std::int16_t>(bytes), 32767);
    case Kind::UnsignedShort:
      return scaled(number_at<std::uint16_t>(bytes), 65535);
    case Kind::UnsignedInt:
      return scaled(number_at<std::uint32_t>(bytes), 4294967295.0);
    case Kind::Float:
      return number_at<float>(bytes);
  }
  return 0;
}

/// Elements that lie somewhere in the file's bytes.
struct Elements {
  std::string_view bytes;
  std::size_t stride = 0, size = 0;  ///< From one to the next; of one.

  const char* at(std::size_t i) const { return bytes.data() + i * stride; }
};

/// Elements of a view from an offset on, all of which are there.
Elements elements_of(Source& source, const Part& part, std::size_t count, std::size_t size) {
  const Source::View view = source.view(part["bufferView"].whole(0, UINT32_MAX));
  const std::uint64_t offset = part["byteOffset"].whole_or(0, UINT32_MAX);
  const std::size_t stride = view.stride == 0 ? size : view.stride;
  if (stride < size) part.fail(fmt::format("has elements of {} bytes, {} apart", size, stride));
  // count <= most_corners and stride <= 256, so nothing overflows.
  const std::size_t end = count == 0 ? 0 : (count - 1) * stride + size;
  if (offset > view.bytes.size() || end > view.bytes.size() - offset)
    part.fail(
        fmt::format("claims {} elements ({} bytes from {} on), and its bufferView has {} "
                    "bytes",
                    count, end, offset, view.bytes.size()));
  return {view.bytes.substr(offset), stride, size};
}

/// Calls `take` with the place and the bytes of each element, in order; those that a sparse
/// accessor replaces come once more. Elements that are nowhere are zeros already.
template <typename Take>
void for_each_element(Source& source, const Part& part, std::size_t count, std::size_t size,
                      Take take) {
  if (part["bufferView"].is_there()) {
    const Elements elements = elements_of(source, part, count, size);
    for (std::size_t i = 0; i < count; ++i) take(i, elements.at(i));
  }
  const Part sparse = part["sparse"];
  if (!sparse.is_there()) return;
  const std::size_t replaced = sparse["count"].whole(1, count);
  const Part places = sparse["indices"];
  const Kind kind = kind_of(places["componentType"]);
  if (kind != Kind::UnsignedByte && kind != Kind::UnsignedShort && kind != Kind::UnsignedInt)
    places["componentType"].fail("must be an unsigned type");
  const Elements at = elements_of(source, places, replaced, size_of(kind));
  const Elements value = elements_of(source, sparse["values"], replaced, size);
  for (std::size_t i = 0; i < replaced; ++i) {
    const auto place = static_cast<std::size_t>(value_at(kind, false, at.at(i)));
    if (place >= count) places.fail(fmt::format("names element {} of {}", place, count));
    take(place, value.at(i));
  }
}

struct Layout {
  Part part;
  Kind kind;
  std::size_t components, count;
  bool is_normalised;
};

Layout layout_of(const Source& source, std::uint64_t accessor, const Part& asked_by) {
  const Part accessors = source.root()["accessors"];
  if (accessor >= accessors.size())
    asked_by.fail(
        fmt::format("names accessor {}, and the file has {}", accessor, accessors.size()));
  const Part part = accessors.at(accessor);
  return {part, kind_of(part["componentType"]), components_of(part["type"]),
          part["count"].whole(1, most_corners), part["normalized"].flag_or(false)};
}

/// Zeros that no byte of the file stands for are few.
void check_zeros(const Layout& layout) {
  constexpr std::size_t most_zeros = 1'000'000;
  if (!layout.part["bufferView"].is_there() && layout.count * layout.components > most_zeros)
    layout.part.fail(fmt::format("claims {} elements and has no bufferView", layout.count));
}

}  // namespace

Numbers read_numbers(Source& source, std::uint64_t accessor, const Part& asked_by) {
  const Layout layout = layout_of(source, accessor, asked_by);
  check_zeros(layout);
  const std::size_t one = size_of(layout.kind);
  if (layout.part["bufferView"].is_there())  // before any memory is taken
    elements_of(source, layout.part, layout.count, one * layout.components);
  Numbers numbers{.components = layout.components, .count = layout.count, .value = {}};
  numbers.value.resize(layout.count * layout.components);
  for_each_element(source, layout.part, layout.count, one * layout.components,
                   [&](std::size_t place, const char* bytes) {
                     for (std::size_t c = 0; c < layout.components; ++c) {
                       const auto value = static_cast<float>(
                           value_at(layout.kind, layout.is_normalised, bytes + c * one));
                       if (!std::isfinite(value))
                         layout.part.fail(fmt::format(
                             "holds a number that is not finite, in element {}", place));
                       numbers.value[place * layout.components + c] = value;
                     }
                   });
  return numbers;
}

Indices read_indices(Source& source, std::uint64_t accessor, const Part& asked_by) {
  const Layout layout = layout_of(source, accessor, asked_by);
  check_zeros(layout);
  if (layout.kind != Kind::UnsignedByte && layout.kind != Kind::UnsignedShort &&
      layout.kind != Kind::UnsignedInt)
    layout.part["componentType"].fail("must be an unsigned type");
  const std::size_t one = size_of(layout.kind);
  if (layout.part["bufferView"].is_there())
    elements_of(source, layout.part, layout.count, one * layout.components);
  Indices indices{.components = layout.components, .count = layout.count, .value = {}};
  indices.value.resize(layout.count * layout.components);
  for_each_element(source, layout.part, layout.count, one * layout.components,
                   [&](std::size_t place, const char* bytes) {
                     for (std::size_t c = 0; c < layout.components; ++c)
                       indices.value[place * layout.components + c] = static_cast<std::uint32_t>(
                           value_at(layout.kind, false, bytes + c * one));
                   });
  return indices;
}

std::size_t count_of(const Source& source, std::uint64_t accessor, const Part& asked_by) {
  return layout_of(source, accessor, asked_by).count;
}

}  // namespace docent::import::gltf
