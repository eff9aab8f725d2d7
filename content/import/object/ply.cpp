#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "content/import/gltf/part.h"
#include "content/import/gltf/texture.h"
#include "content/import/object/kinds.h"
#include "content/import/object/object_text.h"
#include "content/import/object/one_primitive.h"

namespace docent::import::object {
namespace {

enum class Encoding : std::uint8_t { Text, LittleEndian, BigEndian };
enum class Type : std::uint8_t { I8, U8, I16, U16, I32, U32, F32, F64 };

constexpr std::size_t size_of(Type type) {
  constexpr std::array<std::size_t, 8> size{1, 1, 2, 2, 4, 4, 4, 8};
  return size[static_cast<std::size_t>(type)];
}

std::optional<Type> type_of(std::string_view name) {
  constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                  {"uchar", "uint8"},
                                                                  {"short", "int16"},
                                                                  {"ushort", "uint16"},
                                                                  {"int", "int32"},
                                                                  {"uint", "uint32"},
                                                                  {"float", "float32"},
                                                                  {"double", "float64"}}};
  for (std::size_t i = 0; i < names.size(); ++i)
    if (name == names[i][0] || name == names[i][1]) return static_cast<Type>(i);
  return {};
}

struct Property {
  std::string name;
  Type type = Type::F32;
  bool is_list = false;
  Type count_type = Type::U8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::uint32_t line = 0;  ///< Of the header.
  std::vector<Property> properties;
};

/// A PLY file (Turk 1994) while it is read.
class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& file, const gltf::ReadBeside& beside)
      : bytes_{bytes}, file_{file}, beside_{beside} {}

  gltf::Model read() {
    read_header();
    for (const Element& element : elements_) {
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else
        skip(element);
    }
    gltf::Model model = scene_of({std::move(primitive_)});
    read_picture(model);
    model.warnings = faults_.told();
    return model;
  }

 private:
  void read_header() {
    Lines lines(bytes_);
    lines.next();
    bool has_format = false;
    while (lines.next()) {
      const std::string_view word = lines.word();
      if (word == "end_header") {
        if (!has_format) fail(file_, lines.number(), "its header names no format");
        at_ = lines.end();
        line_ = lines.number() + 1;
        return;
      }
      if (word == "format") has_format = take_format(lines);
      if (word == "comment" && lines.word() == "TextureFile") picture_ = lines.rest();
      if (word == "element") take_element(lines);
      if (word == "property") take_property(lines);
    }
    fail(file_, 0, "its header has no end: the file is cut short");
  }

  bool take_format(Lines& lines) {
    const std::string_view name = lines.word();
    if (name != "ascii" && name != "binary_little_endian" && name != "binary_big_endian")
      fail(file_, lines.number(),
           fmt::format("the format '{}' is none of PLY's", gltf::plain_name(name)));
    encoding_ = name == "ascii"                  ? Encoding::Text
                : name == "binary_little_endian" ? Encoding::LittleEndian
                                                 : Encoding::BigEndian;
    return true;
  }

  void take_element(Lines& lines) {
    constexpr std::size_t most = 100;
    const std::string name(lines.word());
    const std::optional<std::int64_t> count = whole_of(lines.word());
    if (name.empty() || !count || *count < 0 || elements_.size() >= most)
      fail(file_, lines.number(), "an element of its header has no name or no count");
    elements_.push_back({name, static_cast<std::size_t>(*count), lines.number(), {}});
  }

  void take_property(Lines& lines) {
    constexpr std::size_t most = 200;
    if (elements_.empty() || elements_.back().properties.size() >= most)
      fail(file_, lines.number(), "a property of its header belongs to no element");
    Property property;
    std::string_view type = lines.word();
    if (type == "list") {
      property.is_list = true;
      const std::optional<Type> count_type = type_of(lines.word());
      if (!count_type || *count_type >= Type::F32)
        fail(file_, lines.number(), "a list of its header has no type of count");
      property.count_type = *count_type;
      type = lines.word();
    }
    const std::optional<Type> known = type_of(type);
    if (!known)
      fail(file_, lines.number(), fmt::format("'{}' is no type of PLY's", gltf::plain_name(type)));
    property.type = *known;
    property.name = lines.word();
    elements_.back().properties.push_back(std::move(property));
  }

  /// Refuses a count that what is left of the file has no room for.
  void check_count(const Element& element) const {
    std::size_t least = 0;
    for (const Property& p : element.properties)
      least += encoding_ == Encoding::Text ? 2 : size_of(p.is_list ? p.count_type : p.type);
    if (least == 0) fail(file_, element.line, fmt::format("{} has no property", element.name));
    // The last number of a text needs no blank behind it.
    const std::size_t room = (bytes_.size() - at_ + 1) / least;
    if (element.count > room)
      fail(file_, element.line,
           fmt::format("it says that there are {} of {}, and has room for {}: the file is cut "
                       "short, or its header wrong",
                       element.count, gltf::plain_name(element.name), room));
  }

  std::string_view next_word() {
    const auto is_blank = [&](std::size_t i) {
      return std::string_view(" \t\r\n\v\f").contains(bytes_[i]);
    };
    while (at_ < bytes_.size() && is_blank(at_)) {
      if (bytes_[at_] == '\n') ++line_;
      ++at_;
    }
    const std::size_t first = at_;
    while (at_ < bytes_.size() && !is_blank(at_)) ++at_;
    return bytes_.substr(first, at_ - first);
  }

  double text_value() {
    const std::string_view word = next_word();
    if (word.empty()) fail(file_, line_, "the file ends before its last number");
    if (const std::optional<float> number = number_of(word)) return *number;
    if (const std::optional<std::int64_t> whole = whole_of(word))
      return static_cast<double>(*whole);
    return std::nan("");
  }

  template <typename Number>
  double binary_value() {
    std::array<char, sizeof(Number)> raw{};
    if (bytes_.size() - at_ < sizeof(Number))
      fail(file_, 0, "the file ends before its last number");
    std::memcpy(raw.data(), bytes_.data() + at_, sizeof(Number));
    at_ += sizeof(Number);
    if ((encoding_ == Encoding::BigEndian) == (std::endian::native == std::endian::little))
      std::ranges::reverse(raw);
    return static_cast<double>(std::bit_cast<Number>(raw));
  }

  double value(Type type) {
    if (encoding_ == Encoding::Text) return text_value();
    switch (type) {
      case Type::I8:
        return binary_value<std::int8_t>();
      case Type::U8:
        return binary_value<std::uint8_t>();
      case Type::I16:
        return binary_value<std::int16_t>();
      case Type::U16:
        return binary_value<std::uint16_t>();
      case Type::I32:
        return binary_value<std::int32_t>();
      case Type::U32:
        return binary_value<std::uint32_t>();
      case Type::F32:
        return binary_value<float>();
      case Type::F64:
        break;
    }
    return binary_value<double>();
  }

  std::size_t list_count(const Property& property) {
    const double count = value(property.count_type);
    const std::size_t least = encoding_ == Encoding::Text ? 2 : size_of(property.type);
    const std::size_t most = (bytes_.size() - at_ + 1) / least;
    if (!(count >= 0) || count > static_cast<double>(most))
      fail(file_, encoding_ == Encoding::Text ? line_ : 0,
           "a list says that it is longer than the file");
    return static_cast<std::size_t>(count);
  }

  void skip_value(const Property& property) {
    const std::size_t count = property.is_list ? list_count(property) : 1;
    for (std::size_t i = 0; i < count; ++i) value(property.type);
  }

  void skip(const Element& element) {
    if (element.count == 0) return;
    check_count(element);
    for (std::size_t i = 0; i < element.count; ++i)
      for (const Property& property : element.properties) skip_value(property);
  }

  /// Which of `names` the property is; none of them where it is another.
  static std::size_t which(const Property& property,
                           std::initializer_list<std::string_view> names) {
    return static_cast<std::size_t>(std::ranges::find(names, property.name) - names.begin());
  }

  void read_vertices(const Element& element) {
    if (has_vertices_) fail(file_, element.line, "it has vertices twice");
    has_vertices_ = true;
    check_count(element);
    count(file_, element.count, most_vertices, "vertices");
    const auto has = [&](std::string_view name) {
      return std::ranges::find(element.properties, name, &Property::name) !=
             element.properties.end();
    };
    for (const std::string_view name : {"x", "y", "z"})
      if (!has(name)) fail(file_, element.line, fmt::format("its vertices have no {}", name));
    const bool has_colour = has("red") && has("green") && has("blue");
    const bool has_uv = has("s") || has("u") || has("texture_u");
    for (std::size_t i = 0; i < element.count; ++i) {
      Vec3 place{0};
      Vec4 colour{1};
      glm::vec2 uv{0};
      for (const Property& property : element.properties) {
        if (property.is_list) {
          skip_value(property);
          continue;
        }
        const double number = value(property.type);
        if (const std::size_t axis = which(property, {"x", "y", "z"}); axis < 3)
          place[static_cast<int>(axis)] = static_cast<float>(number);
        else if (const std::size_t part = which(property, {"red", "green", "blue"}); part < 3)
          colour[static_cast<int>(part)] = linear_of(share_of(number, property.type));
        else if (which(property, {"s", "u", "texture_u"}) < 3)
          uv.x = static_cast<float>(number);
        else if (which(property, {"t", "v", "texture_v"}) < 3)
          uv.y = 1 - static_cast<float>(number);
      }
      constexpr float farthest = 1e6F;
      const bool is_sound =
          std::max({std::abs(place.x), std::abs(place.y), std::abs(place.z)}) <= farthest;
      if (!is_sound || !std::isfinite(place.x + place.y + place.z)) {
        faults_.add(encoding_ == Encoding::Text ? line_ : 0,
                    "a vertex is nowhere; its faces are left out");
        lost_.push_back(static_cast<std::uint32_t>(i));
        place = Vec3{0};
      }
      primitive_.position.push_back(place);
      if (has_colour) primitive_.colour.push_back(colour);
      if (has_uv) primitive_.uv.push_back(std::isfinite(uv.x + uv.y) ? uv : glm::vec2(0));
    }
  }

  static float share_of(double number, Type type) {
    constexpr double of_byte = 255, of_short = 65535;
    if (!std::isfinite(number)) return 1;
    if (type >= Type::F32) return static_cast<float>(number);
    return static_cast<float>(number / (size_of(type) == 2 ? of_short : of_byte));
  }

  void read_faces(const Element& element) {
    if (element.count == 0) return;
    check_count(element);
    constexpr std::size_t most_of_a_face = 1000;
    std::size_t triangles = 0;
    std::vector<std::uint32_t> corners;
    for (std::size_t i = 0; i < element.count; ++i) {
      bool is_whole = true;
      corners.clear();
      for (const Property& property : element.properties) {
        if (!property.is_list || which(property, {"vertex_indices", "vertex_index"}) == 2) {
          skip_value(property);
          continue;
        }
        const std::size_t count = list_count(property);
        for (std::size_t k = 0; k < count; ++k) {
          const double index = value(property.type);
          const bool is_there =
              index >= 0 && index < static_cast<double>(primitive_.position.size());
          is_whole = is_whole && is_there && k < most_of_a_face;
          if (is_whole) corners.push_back(static_cast<std::uint32_t>(index));
        }
      }
      for (const std::uint32_t corner : corners)
        is_whole = is_whole && !std::ranges::binary_search(lost_, corner);
      if (!is_whole) {
        faults_.add(encoding_ == Encoding::Text ? line_ : 0,
                    "a face names a vertex that is not there; it is left out");
        continue;
      }
      triangles += corners.size();
      count(file_, triangles, most_triangles, "triangles");
      add_polygon(corners, primitive_);
    }
  }

  void read_picture(gltf::Model& model) {
    if (picture_.empty() || model.meshes.front().primitives.empty()) return;
    gltf::Primitive& primitive = model.meshes.front().primitives.front();
    const std::string name(picture_);
    const bool may_be_read = beside_ && gltf::stays_below(name);
    const std::optional<std::string> bytes = may_be_read ? beside_(name) : std::nullopt;
    if (!bytes)
      return faults_.add(
          0, fmt::format("there is no file '{}' beside the model", gltf::plain_name(name)));
    Result<Pixels> pixels = gltf::decode_texture(*bytes);
    if (!pixels)
      return faults_.add(0, fmt::format("its picture '{}' cannot be shown ({})",
                                        gltf::plain_name(name), pixels.error().what));
    if (primitive.uv.empty()) return;
    model.images.push_back(std::move(*pixels));
    model.materials.emplace_back().image = 0;
    primitive.material = 0;
  }

  std::string_view bytes_;
  const std::string& file_;
  const gltf::ReadBeside& beside_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 0;
  Encoding encoding_ = Encoding::Text;
  std::vector<Element> elements_;
  std::string_view picture_;
  bool has_vertices_ = false;
  std::vector<std::uint32_t> lost_;  ///< Vertices that are nowhere, ascending.
  gltf::Primitive primitive_;
  Faults faults_;
};

}  // namespace

bool is_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

gltf::Model parse_ply(std::string_view bytes, const std::string& file,
                      const gltf::ReadBeside& beside) {
  return PlyReader(bytes, file, beside).read();
}

}  // namespace docent::import::object
