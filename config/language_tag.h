#pragma once

#include <string>
#include <string_view>

namespace docent::config {

/// Can this be a language's tag (BCP 47): a code of ISO 639, with a script and a region where they
/// are needed, in their usual letter cases ("en", "zh-Hant", "pt-BR")? Codes of two letters are
/// looked up; those of three are taken on trust.
bool is_language_tag(std::string_view tag);

/// The tag that staff may have meant by a word that is none ("EN", "english", "cz", "pt_br");
/// empty where none is near.
std::string meant_language(std::string_view word);

}  // namespace docent::config
