#include "content/import/gltf/part.h"

#include <cmath>

namespace docent::import::gltf {

Part Part::operator[](std::string_view key) const {
  if (json_ == nullptr) fail("is missing");
  if (!json_->is_object()) fail("must be an object");
  const auto found = json_->find(key);
  std::string name = name_.empty() ? std::string(key) : fmt::format("{}.{}", name_, key);
  return {*file_, found == json_->end() ? nullptr : &*found, std::move(name)};
}

Part Part::at(std::uint64_t index) const {
  if (json_ == nullptr) fail("is missing");
  if (!json_->is_array()) fail("must be a list");
  if (index >= json_->size())
    fail(fmt::format("has {} entries, and [{}] is asked for", json_->size(), index));
  return {*file_, &(*json_)[index], fmt::format("{}[{}]", name_, index)};
}

std::size_t Part::size() const {
  if (json_ == nullptr) return 0;
  if (!json_->is_array()) fail("must be a list");
  return json_->size();
}

std::uint64_t Part::whole(std::uint64_t least, std::uint64_t most) const {
  if (json_ == nullptr) fail("is missing");
  std::uint64_t value = 0;
  if (json_->is_number_unsigned()) {
    value = json_->get<std::uint64_t>();
  } else if (json_->is_number_float()) {  // some exporters write 3.0
    const double number = json_->get<double>();
    if (!(number >= 0 && number < 9e15) || number != std::floor(number))
      fail("must be a whole number");
    value = static_cast<std::uint64_t>(number);
  } else {
    fail("must be a whole number");
  }
  if (value < least || value > most)
    fail(fmt::format("is {}, and must be from {} to {}", value, least, most));
  return value;
}

std::int32_t Part::index_or_none(std::size_t count, std::string_view noun) const {
  if (!is_there()) return -1;
  const std::uint64_t index = whole(0, UINT64_MAX);
  if (index >= count) fail(fmt::format("names {} {}, and the file has {}", noun, index, count));
  return static_cast<std::int32_t>(index);
}

float Part::number() const {
  if (json_ == nullptr) fail("is missing");
  if (!json_->is_number()) fail("must be a number");
  const auto value = static_cast<float>(json_->get<double>());
  if (!std::isfinite(value)) fail("is too large a number");
  return value;
}

bool Part::flag_or(bool otherwise) const {
  if (!is_there()) return otherwise;
  if (!json_->is_boolean()) fail("must be true or false");
  return json_->get<bool>();
}

std::string Part::text() const {
  if (json_ == nullptr) fail("is missing");
  if (!json_->is_string()) fail("must be a text");
  return json_->get<std::string>();
}

Vec3 Part::vec3_or(Vec3 otherwise) const {
  if (!is_there()) return otherwise;
  if (size() != 3) fail("must have three numbers");
  return {at(0).number(), at(1).number(), at(2).number()};
}

Vec4 Part::vec4_or(Vec4 otherwise) const {
  if (!is_there()) return otherwise;
  if (size() != 4) fail("must have four numbers");
  return {at(0).number(), at(1).number(), at(2).number(), at(3).number()};
}

std::vector<std::string> Part::keys() const {
  std::vector<std::string> keys;
  if (json_ == nullptr) return keys;
  if (!json_->is_object()) fail("must be an object");
  for (const auto& [key, ignored] : json_->items()) keys.push_back(key);
  return keys;
}

std::string plain_name(std::string_view name) {
  std::string plain;
  for (const char c : name.substr(0, 200))
    plain += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? '?' : c;
  return plain;
}

}  // namespace docent::import::gltf
