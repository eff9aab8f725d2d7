#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/fields.h"

/// What to write in place of what a table should not hold. Internal to config.
namespace docent::config {

bool is_number(const TomlNode& node);
bool is_pair_of_numbers(const TomlNode& node);
/// Letters, digits, hyphens, dots and underscores, and at least one.
bool is_identifier(std::string_view text);

/// What to write for `key` instead of a value of the wrong type; `expected` is what its sentence
/// says that it should be.
std::string type_hint(const TomlNode& node, std::string_view key, std::string_view expected);

/// What to write for `key` instead of a text of the wrong form, and what is wrong with it in a few
/// words.
std::string form_hint(std::string_view key, Form form, std::span<const std::string_view> choices,
                      std::string_view text);
std::string form_label(Form form, std::string_view text);

/// What a key was meant as that a section does not know, or where it belongs.
std::string key_hint(std::string_view key, std::string_view section,
                     const std::vector<std::string_view>& known);

}  // namespace docent::config
