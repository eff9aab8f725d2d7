#include "config/language_tag.h"

#include <algorithm>
#include <array>
#include <vector>

#include "config/letters.h"
#include "platform/terminal/suggest.h"

namespace docent::config {

namespace {

struct NamedLanguage {
  std::string_view code, name;
};

/// ISO 639-1, with the names by which people may look for them.
constexpr std::array<NamedLanguage, 183> languages{{
    {"aa", "afar"},        {"ab", "abkhazian"},     {"ae", "avestan"},    {"af", "afrikaans"},
    {"ak", "akan"},        {"am", "amharic"},       {"an", "aragonese"},  {"ar", "arabic"},
    {"as", "assamese"},    {"av", "avaric"},        {"ay", "aymara"},     {"az", "azerbaijani"},
    {"ba", "bashkir"},     {"be", "belarusian"},    {"bg", "bulgarian"},  {"bi", "bislama"},
    {"bm", "bambara"},     {"bn", "bengali"},       {"bo", "tibetan"},    {"br", "breton"},
    {"bs", "bosnian"},     {"ca", "catalan"},       {"ce", "chechen"},    {"ch", "chamorro"},
    {"co", "corsican"},    {"cr", "cree"},          {"cs", "czech"},      {"cu", "slavonic"},
    {"cv", "chuvash"},     {"cy", "welsh"},         {"da", "danish"},     {"de", "german"},
    {"dv", "dhivehi"},     {"dz", "dzongkha"},      {"ee", "ewe"},        {"el", "greek"},
    {"en", "english"},     {"eo", "esperanto"},     {"es", "spanish"},    {"et", "estonian"},
    {"eu", "basque"},      {"fa", "persian"},       {"ff", "fulah"},      {"fi", "finnish"},
    {"fj", "fijian"},      {"fo", "faroese"},       {"fr", "french"},     {"fy", "frisian"},
    {"ga", "irish"},       {"gd", "gaelic"},        {"gl", "galician"},   {"gn", "guarani"},
    {"gu", "gujarati"},    {"gv", "manx"},          {"ha", "hausa"},      {"he", "hebrew"},
    {"hi", "hindi"},       {"ho", "hiri motu"},     {"hr", "croatian"},   {"ht", "haitian"},
    {"hu", "hungarian"},   {"hy", "armenian"},      {"hz", "herero"},     {"ia", "interlingua"},
    {"id", "indonesian"},  {"ie", "interlingue"},   {"ig", "igbo"},       {"ii", "nuosu"},
    {"ik", "inupiaq"},     {"io", "ido"},           {"is", "icelandic"},  {"it", "italian"},
    {"iu", "inuktitut"},   {"ja", "japanese"},      {"jv", "javanese"},   {"ka", "georgian"},
    {"kg", "kongo"},       {"ki", "kikuyu"},        {"kj", "kwanyama"},   {"kk", "kazakh"},
    {"kl", "greenlandic"}, {"km", "khmer"},         {"kn", "kannada"},    {"ko", "korean"},
    {"kr", "kanuri"},      {"ks", "kashmiri"},      {"ku", "kurdish"},    {"kv", "komi"},
    {"kw", "cornish"},     {"ky", "kyrgyz"},        {"la", "latin"},      {"lb", "luxembourgish"},
    {"lg", "ganda"},       {"li", "limburgish"},    {"ln", "lingala"},    {"lo", "lao"},
    {"lt", "lithuanian"},  {"lu", "luba"},          {"lv", "latvian"},    {"mg", "malagasy"},
    {"mh", "marshallese"}, {"mi", "maori"},         {"mk", "macedonian"}, {"ml", "malayalam"},
    {"mn", "mongolian"},   {"mr", "marathi"},       {"ms", "malay"},      {"mt", "maltese"},
    {"my", "burmese"},     {"na", "nauru"},         {"nb", "bokmal"},     {"nd", "ndebele"},
    {"ne", "nepali"},      {"ng", "ndonga"},        {"nl", "dutch"},      {"nn", "nynorsk"},
    {"no", "norwegian"},   {"nr", "south ndebele"}, {"nv", "navajo"},     {"ny", "chichewa"},
    {"oc", "occitan"},     {"oj", "ojibwa"},        {"om", "oromo"},      {"or", "odia"},
    {"os", "ossetian"},    {"pa", "punjabi"},       {"pi", "pali"},       {"pl", "polish"},
    {"ps", "pashto"},      {"pt", "portuguese"},    {"qu", "quechua"},    {"rm", "romansh"},
    {"rn", "rundi"},       {"ro", "romanian"},      {"ru", "russian"},    {"rw", "kinyarwanda"},
    {"sa", "sanskrit"},    {"sc", "sardinian"},     {"sd", "sindhi"},     {"se", "northern sami"},
    {"sg", "sango"},       {"si", "sinhala"},       {"sk", "slovak"},     {"sl", "slovenian"},
    {"sm", "samoan"},      {"sn", "shona"},         {"so", "somali"},     {"sq", "albanian"},
    {"sr", "serbian"},     {"ss", "swati"},         {"st", "sotho"},      {"su", "sundanese"},
    {"sv", "swedish"},     {"sw", "swahili"},       {"ta", "tamil"},      {"te", "telugu"},
    {"tg", "tajik"},       {"th", "thai"},          {"ti", "tigrinya"},   {"tk", "turkmen"},
    {"tl", "tagalog"},     {"tn", "tswana"},        {"to", "tongan"},     {"tr", "turkish"},
    {"ts", "tsonga"},      {"tt", "tatar"},         {"tw", "twi"},        {"ty", "tahitian"},
    {"ug", "uyghur"},      {"uk", "ukrainian"},     {"ur", "urdu"},       {"uz", "uzbek"},
    {"ve", "venda"},       {"vi", "vietnamese"},    {"vo", "volapuk"},    {"wa", "walloon"},
    {"wo", "wolof"},       {"xh", "xhosa"},         {"yi", "yiddish"},    {"yo", "yoruba"},
    {"za", "zhuang"},      {"zh", "chinese"},       {"zu", "zulu"},
}};

/// What people write for a language that has another code: its name in itself, its country, the
/// code that it had once, or one of the three letters of ISO 639-2, which are not used where there
/// are two.
constexpr std::array<NamedLanguage, 83> nicknames{{
    {"cs", "cz"},         {"ja", "jp"},        {"zh", "cn"},        {"el", "gr"},
    {"da", "dk"},         {"en", "gb"},        {"en", "us"},        {"uk", "ua"},
    {"he", "iw"},         {"id", "in"},        {"yi", "ji"},        {"de", "deutsch"},
    {"fr", "francais"},   {"fr", "français"},  {"es", "espanol"},   {"es", "español"},
    {"it", "italiano"},   {"pt", "portugues"}, {"pt", "português"}, {"nl", "nederlands"},
    {"zh", "mandarin"},   {"tlh", "klingon"},  {"fa", "farsi"},     {"pl", "polski"},
    {"sv", "svenska"},    {"da", "dansk"},     {"no", "norsk"},     {"fi", "suomi"},
    {"cs", "čeština"},    {"hu", "magyar"},    {"ro", "română"},    {"tr", "türkçe"},
    {"vi", "tiếng việt"}, {"ru", "русский"},   {"ru", "Русский"},   {"uk", "українська"},
    {"uk", "Українська"}, {"el", "ελληνικά"},  {"el", "Ελληνικά"},  {"ar", "العربية"},
    {"ar", "عربي"},       {"fa", "فارسی"},     {"ur", "اردو"},      {"he", "עברית"},
    {"hi", "हिन्दी"},      {"th", "ไทย"},       {"zh", "中文"},      {"ja", "日本語"},
    {"ko", "한국어"},     {"en", "eng"},       {"de", "deu"},       {"de", "ger"},
    {"fr", "fra"},        {"fr", "fre"},       {"es", "spa"},       {"it", "ita"},
    {"ar", "ara"},        {"zh", "zho"},       {"zh", "chi"},       {"ja", "jpn"},
    {"ko", "kor"},        {"ru", "rus"},       {"pt", "por"},       {"nl", "nld"},
    {"nl", "dut"},        {"pl", "pol"},       {"tr", "tur"},       {"el", "ell"},
    {"el", "gre"},        {"he", "heb"},       {"hi", "hin"},       {"uk", "ukr"},
    {"sv", "swe"},        {"da", "dan"},       {"no", "nor"},       {"fi", "fin"},
    {"cs", "ces"},        {"cs", "cze"},       {"hu", "hun"},       {"ro", "ron"},
    {"vi", "vie"},        {"th", "tha"},       {"fa", "fas"},
}};

bool is_code(std::string_view code) {
  if (!std::ranges::all_of(code, is_lower)) return false;
  if (code.size() == 2)
    return std::ranges::find(languages, code, &NamedLanguage::code) != languages.end();
  return code.size() == 3 &&
         std::ranges::find(nicknames, code, &NamedLanguage::name) == nicknames.end();
}

/// A script ("Hant"), a region ("BR", "419") or a variant ("1996", "valencia"), as it is written.
bool is_subtag(std::string_view part) {
  const bool letters = std::ranges::all_of(part, is_letter);
  if (part.size() == 2) return letters && !is_lower(part[0]) && !is_lower(part[1]);
  if (part.size() == 3) return std::ranges::all_of(part, is_digit);
  if (part.size() == 4 && letters)
    return !is_lower(part[0]) && std::ranges::all_of(part.substr(1), is_lower);
  return (part.size() >= 4 && part.size() <= 8) &&
         std::ranges::all_of(part, [](char c) { return is_lower(c) || is_digit(c); });
}

std::vector<std::string> parts_of(std::string_view tag) {
  std::vector<std::string> parts(1);
  for (const char c : tag)
    if (c == '-' || c == '_')
      parts.emplace_back();
    else
      parts.back() += c;
  return parts;
}

/// The parts in their usual letter cases.
std::string in_usual_case(std::vector<std::string> parts) {
  std::string tag;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    std::string& part = parts[i];
    std::ranges::transform(part, part.begin(), to_lower);
    if (i > 0 && part.size() == 2) std::ranges::transform(part, part.begin(), to_upper);
    if (i > 0 && part.size() == 4 && is_letter(part[0])) part[0] = to_upper(part[0]);
    tag += (i > 0 ? "-" : "") + part;
  }
  return tag;
}

}  // namespace

bool is_language_tag(std::string_view tag) {
  if (tag.find('_') != std::string_view::npos) return false;
  const std::vector<std::string> parts = parts_of(tag);
  return is_code(parts.front()) && std::all_of(parts.begin() + 1, parts.end(), is_subtag);
}

std::string meant_language(std::string_view word) {
  if (std::string tag = in_usual_case(parts_of(word)); is_language_tag(tag) && tag != word)
    return tag;
  const std::string small = in_small_letters(std::string(word));
  for (const NamedLanguage& nickname : nicknames)
    if (nickname.name == small || nickname.name == word) return std::string(nickname.code);
  std::vector<std::string_view> names;
  for (const NamedLanguage& language : languages) names.push_back(language.name);
  const std::string_view near = terminal::closest(small, names);
  const auto found = std::ranges::find(languages, near, &NamedLanguage::name);
  return near.empty() || found == languages.end() ? "" : std::string(found->code);
}

}  // namespace docent::config
