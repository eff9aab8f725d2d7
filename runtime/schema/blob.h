#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

#include "runtime/model/geometry/vec2.h"

/// Arrays as bytes: a blob holds the elements one after another, each field by field, little-endian
/// and without padding, so that the same values are the same bytes on every machine.
///
/// A struct becomes an element by a function `fields(io, value)` beside this namespace's others
/// (elements.h), which names its fields once for both directions.
namespace docent::schema {

/// T itself or const T: lets one function serve encoding and decoding.
template <typename T, typename U>
concept MaybeConst = std::same_as<std::remove_const_t<T>, U>;

template <typename T>
concept Scalar = std::is_arithmetic_v<T> || std::is_enum_v<T>;

void fields(auto& io, MaybeConst<Vec2> auto& v) {
  io(v.x, v.y);
}
void fields(auto& io, MaybeConst<Vec3> auto& v) {
  io(v.x, v.y, v.z);
}
void fields(auto& io, MaybeConst<Quat> auto& q) {
  io(q.x, q.y, q.z, q.w);
}
void fields(auto& io, MaybeConst<Mat4> auto& m) {  // column by column
  for (int column = 0; column < 4; ++column) io(m[column].x, m[column].y, m[column].z, m[column].w);
}
void fields(auto& io, MaybeConst<Placement> auto& p) {
  io(p.position, p.heading);
}

namespace detail {

/// The unsigned integer that carries a scalar's bits.
template <std::size_t size>
using Bits = std::conditional_t<
    size == 1, std::uint8_t,
    std::conditional_t<size == 2, std::uint16_t,
                       std::conditional_t<size == 4, std::uint32_t, std::uint64_t>>>;

template <Scalar T>
constexpr auto to_bits(T value) noexcept {
  if constexpr (std::is_same_v<T, bool>)
    return static_cast<std::uint8_t>(value ? 1 : 0);
  else
    return std::bit_cast<Bits<sizeof(T)>>(value);
}

template <Scalar T>
constexpr T from_bits(Bits<sizeof(T)> bits) noexcept {
  if constexpr (std::is_same_v<T, bool>)
    return bits != 0;  // any other byte would not be a valid bool
  else
    return std::bit_cast<T>(bits);
}

/// Does T lie in memory as it lies in a blob? Then it is copied when it is read. An optimiser makes
/// that of a loop over its bytes too, where it may: with sanitizers that loop was a quarter of what
/// a kiosk does until its first frame.
template <typename T>
constexpr bool lies_as_stored =
    Scalar<T> && !std::is_same_v<T, bool> && std::endian::native == std::endian::little;

}  // namespace detail

// The three visitors live in this namespace, so that a call of fields(visitor, value) finds every
// overload in it, also those that are declared later.

/// Counts the bytes of an element.
struct Measure {
  std::size_t size = 0;

  template <typename... T>
  void operator()(const T&... value) {
    (add(value), ...);
  }
  template <typename T>
  void add(const T& value) {
    if constexpr (Scalar<T>)
      size += sizeof(T);
    else
      fields(*this, value);
  }
  template <typename T, std::size_t n>
  void add(const std::array<T, n>& values) {
    for (const T& value : values) add(value);
  }
};

/// Writes elements where `at` points and moves it on.
struct Encode {
  std::byte* at;

  template <typename... T>
  void operator()(const T&... value) {
    (add(value), ...);
  }
  template <typename T>
  void add(const T& value) {
    if constexpr (Scalar<T>) {
      const auto bits = detail::to_bits(value);
      for (std::size_t i = 0; i < sizeof(T); ++i)
        *at++ = static_cast<std::byte>(static_cast<std::uint64_t>(bits) >> (8 * i));
    } else {
      fields(*this, value);
    }
  }
  template <typename T, std::size_t n>
  void add(const std::array<T, n>& values) {
    for (const T& value : values) add(value);
  }
};

/// Reads elements from where `at` points and moves it on; the caller has checked that they are
/// there.
struct Decode {
  const std::byte* at;

  template <typename... T>
  void operator()(T&... value) {
    (add(value), ...);
  }
  template <typename T>
  void add(T& value) {
    if constexpr (detail::lies_as_stored<T>) {
      std::memcpy(&value, at, sizeof(T));
      at += sizeof(T);
    } else if constexpr (Scalar<T>) {
      std::uint64_t bits = 0;
      for (std::size_t i = 0; i < sizeof(T); ++i)
        bits |= std::to_integer<std::uint64_t>(*at++) << (8 * i);
      value = detail::from_bits<T>(static_cast<detail::Bits<sizeof(T)>>(bits));
    } else {
      fields(*this, value);
    }
  }
  template <typename T, std::size_t n>
  void add(std::array<T, n>& values) {
    for (T& value : values) add(value);
  }
};

/// Bytes that one element takes.
template <typename T>
std::size_t encoded_size() {
  Measure measure;
  measure.add(T{});
  return measure.size;
}

/// The elements as bytes.
template <typename T>
std::vector<std::byte> encode(std::span<const T> elements) {
  std::vector<std::byte> bytes(elements.size() * encoded_size<T>());
  Encode encoder{bytes.data()};
  for (const T& element : elements) encoder.add(element);
  return bytes;
}
template <typename T>
std::vector<std::byte> encode(const std::vector<T>& elements) {
  return encode(std::span<const T>(elements));
}
inline std::vector<std::byte> encode(const std::vector<bool>& elements) {
  return encode(std::vector<std::uint8_t>(elements.begin(), elements.end()));
}
template <typename T, std::size_t n>
std::vector<std::byte> encode(const std::array<T, n>& elements) {
  return encode(std::span<const T>(elements));
}

/// Replaces `elements` by those that the bytes hold; false, and nothing changed, where the bytes do
/// not hold a whole number of them (for an array: exactly as many as it has). Every bit pattern
/// decodes to some value: whether it makes sense is for the reader to say.
template <typename T>
[[nodiscard]] bool decode(std::span<const std::byte> bytes, std::vector<T>& elements) {
  const std::size_t size = encoded_size<T>();
  if (bytes.size() % size != 0) return false;
  elements.assign(bytes.size() / size, T{});
  if constexpr (detail::lies_as_stored<T>) {
    if (!bytes.empty()) std::memcpy(elements.data(), bytes.data(), bytes.size());
    return true;
  }
  Decode decoder{bytes.data()};
  for (T& element : elements) decoder.add(element);
  return true;
}
[[nodiscard]] inline bool decode(std::span<const std::byte> bytes, std::vector<bool>& elements) {
  elements.clear();
  for (const std::byte byte : bytes) elements.push_back(byte != std::byte{0});
  return true;
}
template <typename T, std::size_t n>
[[nodiscard]] bool decode(std::span<const std::byte> bytes, std::array<T, n>& elements) {
  if (bytes.size() != n * encoded_size<T>()) return false;
  Decode decoder{bytes.data()};
  for (T& element : elements) decoder.add(element);
  return true;
}

}  // namespace docent::schema
