#include "content/import/floor/json.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>

#include "content/import/floor/json_fault.h"
#include "content/read_source.h"

namespace docent::import {
namespace {

constexpr std::size_t deepest_nesting = 64;

/// Walks a text and tells a witness how far the parser has read. The parser's events carry no
/// position of their own.
class WatchedIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  WatchedIterator(std::string_view::const_iterator at, std::size_t* bytes_read)
      : at_(at), bytes_read_(bytes_read) {}

  reference operator*() const { return *at_; }
  WatchedIterator& operator++() {
    ++at_;
    ++*bytes_read_;
    return *this;
  }
  WatchedIterator operator++(int) {
    WatchedIterator before = *this;
    ++*this;
    return before;
  }
  bool operator==(const WatchedIterator& other) const { return at_ == other.at_; }

 private:
  std::string_view::const_iterator at_;
  std::size_t* bytes_read_;
};

/// Receives the parser's events and builds the tree.
class TreeBuilder : public nlohmann::json_sax<nlohmann::json> {
 public:
  TreeBuilder(const std::string& file, std::string_view text, const std::size_t* bytes_read)
      : file_(file), text_(text), bytes_read_(bytes_read) {}

  JsonValue take_root() { return std::move(root_); }

  bool null() override { return add_scalar({.kind = JsonValue::Kind::Null}, *bytes_read_ - 4); }
  bool boolean(bool value) override {
    return add_scalar({.kind = JsonValue::Kind::Boolean, .number = value ? 1.0 : 0.0},
                      *bytes_read_ - (value ? 4 : 5));
  }
  bool number_integer(number_integer_t value) override {
    return add_number(static_cast<double>(value));
  }
  bool number_unsigned(number_unsigned_t value) override {
    return add_number(static_cast<double>(value));
  }
  bool number_float(number_float_t value, const string_t& /*digits*/) override {
    return add_number(value);
  }
  bool string(string_t& value) override {
    return add_scalar({.kind = JsonValue::Kind::String, .string = std::move(value)},
                      string_start());
  }
  bool binary(binary_t& /*value*/) override { return false; }  // JSON text holds none.

  bool start_object(std::size_t /*size*/) override { return open(JsonValue::Kind::Object); }
  bool key(string_t& name) override {
    open_.back()->names.push_back(std::move(name));
    return true;
  }
  bool end_object() override { return close(); }
  bool start_array(std::size_t /*size*/) override { return open(JsonValue::Kind::Array); }
  bool end_array() override { return close(); }

  bool parse_error(std::size_t position, const std::string& /*token*/,
                   const nlohmann::json::exception& error) override {
    constexpr int number_overflow = 406;
    if (error.id == number_overflow)
      fail(number_start(), "a number is too large", "write it in metres, with few figures: 12.5");
    const JsonFault fault =
        explain_json_fault(text_, position - std::min<std::size_t>(position, 1));
    fail(fault.offset, fault.message, fault.hint);
    return false;
  }

 private:
  [[noreturn]] void fail(std::size_t offset, const std::string& message, std::string hint) const {
    const auto [line, column] = LineIndex(text_).at(offset);
    throw content::ContentError(file_, line, column, "unreadable-json", message, std::move(hint));
  }

  /// A number's end is only known by reading one byte beyond it.
  [[nodiscard]] std::size_t number_start() const {
    const auto is_part = [](char c) {
      return (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.' || c == 'e' || c == 'E';
    };
    std::size_t start = std::min(*bytes_read_, text_.size());
    if (start > 0 && !is_part(text_[start - 1])) --start;
    while (start > 0 && is_part(text_[start - 1])) --start;
    return start;
  }

  /// The quote that opens the string whose closing quote was just read.
  [[nodiscard]] std::size_t string_start() const {
    std::size_t quote = *bytes_read_ - 1;
    while (quote > 0) {
      quote = text_.rfind('"', quote - 1);
      std::size_t backslashes = 0;
      while (backslashes < quote && text_[quote - 1 - backslashes] == '\\') ++backslashes;
      if (backslashes % 2 == 0) break;
    }
    return quote;
  }

  JsonValue& add(JsonValue value, std::size_t offset) {
    value.offset = offset;
    if (open_.empty()) return root_ = std::move(value);
    return open_.back()->items.emplace_back(std::move(value));
  }
  bool add_scalar(JsonValue value, std::size_t offset) {
    add(std::move(value), offset);
    return true;
  }
  bool add_number(double value) {
    return add_scalar({.kind = JsonValue::Kind::Number, .number = value}, number_start());
  }
  bool open(JsonValue::Kind kind) {
    const std::size_t offset = *bytes_read_ - 1;
    if (open_.size() == deepest_nesting)
      fail(offset, "the values are nested too deeply",
           "a floor is a FeatureCollection of Polygons: export it again");
    // The pointers of enclosing values stay good: a container grows only while it is the innermost.
    open_.push_back(&add({.kind = kind}, offset));
    return true;
  }
  bool close() {
    open_.pop_back();
    return true;
  }

  const std::string& file_;
  std::string_view text_;
  const std::size_t* bytes_read_;
  JsonValue root_;
  std::vector<JsonValue*> open_;  ///< The containers about the current place, outermost first.
};

}  // namespace

const JsonValue* find_member(const JsonValue& object, std::string_view name) noexcept {
  for (std::size_t i = object.names.size(); i-- > 0;)
    if (object.names[i] == name && i < object.items.size()) return &object.items[i];
  return nullptr;
}

LineIndex::LineIndex(std::string_view text) : line_start_{0} {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) continued_.push_back(i);
    if (text[i] == '\n') line_start_.push_back(i + 1);
  }
}

TextPosition LineIndex::at(std::size_t offset) const noexcept {
  const auto after = std::upper_bound(line_start_.begin(), line_start_.end(), offset);
  const auto line = static_cast<std::size_t>(after - line_start_.begin());
  const std::size_t start = line_start_[line - 1];
  const auto continued =
      std::ranges::lower_bound(continued_, offset) - std::ranges::lower_bound(continued_, start);
  return {static_cast<std::uint32_t>(line),
          static_cast<std::uint32_t>(offset - start + 1) - static_cast<std::uint32_t>(continued)};
}

JsonValue parse_json(const std::string& file, std::string_view text) {
  if (const auto fault = file::encoding_fault(text))
    throw content::to_content_error(*fault, file, "unreadable-json");
  std::size_t bytes_read = 0;
  TreeBuilder builder(file, text, &bytes_read);
  nlohmann::json::sax_parse(WatchedIterator(text.begin(), &bytes_read),
                            WatchedIterator(text.end(), &bytes_read), &builder);
  return builder.take_root();
}

}  // namespace docent::import
