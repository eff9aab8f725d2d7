#include "content/import/drawing/layer_kind.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

#include "content/import/drawing/lower_case.h"

namespace docent::import {
namespace {

/// Beginnings of words in Latin letters, lower case.
struct Words {
  LayerKind kind;
  std::vector<std::string_view> beginnings;
};

/// In the order in which they win: a `wall text` holds text, a `stair wall` a wall.
const std::vector<Words>& words() {
  static const std::vector<Words> all = {
      {LayerKind::Other,
       {"dim",    "text",    "txt",   "note",       "anno",    "hatch",   "schraff", "hachur",
        "patt",   "furn",    "moeb",  "mobel",      "mobil",   "meubl",   "inrich",  "defp",
        "axis",   "axes",    "achse", "grid",       "raster",  "foot",    "found",   "fund",
        "stem",   "slab",    "roof",  "dach",       "toit",    "ceil",    "clng",    "decke",
        "plafon", "elec",    "elek",  "light",      "lamp",    "sanit",   "plumb",   "bemass",
        "cota",   "quote",   "cotat", "masskette",  "title",   "frame",   "border",  "viewport",
        "vport",  "plant",   "tree",  "site",       "header",  "beam",    "symb",    "number",
        "legend", "revis",   "image", "background", "journey", "distrib", "param",   "audit",
        "luft",   "venti",   "hvac",  "fixt",       "case",    "equip",   "applia",  "section",
        "elev",   "view",    "osn",   "mebl",       "meble",   "butor",   "mobily",  "yazi",
        "opis",   "felirat", "cotes", "olcu"}},
      {LayerKind::Wall,
       {"wall",    "wand",    "waende",  "mur",    "muri",    "mauer",   "muro",   "pared",
        "parete",  "paret",   "parede",  "sten",   "scian",   "vegg",    "vaeg",   "veg",
        "seina",   "muur",    "zed",     "partit", "cloison", "trennw",  "tabiqu", "gips",
        "plaster", "drywall", "concr",   "beton",  "column",  "colum",   "col",    "stutz",
        "stuetz",  "pilar",   "poteau",  "walk",   "obstac",  "outline", "facade", "fassade",
        "struct",  "tragend", "aussenw", "innenw", "duvar",   "falak",   "stena",  "steny",
        "tuong",   "dinding"}},
      {LayerKind::Window, {"wind",   "fenst",  "fenet",   "fines", "glaz",  "glas",   "glass",
                           "vent",   "ventan", "okno",    "okna",  "janel", "raam",   "vindu",
                           "pencer", "ablak",  "opening", "oeffn", "offn",  "ouvert", "curtain"}},
      {LayerKind::Door,
       {"door", "tuer", "tur", "tueren", "porte", "porta", "puert", "deur", "dor", "dveri", "dver",
        "drzwi", "ovi", "exit", "gate", "garage", "kapi", "ajto", "pintu"}},
      {LayerKind::Room,
       {"room", "raum", "zone", "space", "spaz", "piece", "local", "locaux", "estanc", "ambient",
        "area", "rum", "ruimte", "zind"}},
      {LayerKind::Stairs,
       {"stair", "strs", "stairs", "trepp", "escal", "scal", "lift", "elevator", "aufzug", "ascens",
        "ramp", "comunic", "commun", "trapp"}},
  };
  return all;
}

/// Names in other scripts have no words to part: anywhere in the name.
const std::vector<std::pair<std::string_view, LayerKind>>& parts() {
  static const std::vector<std::pair<std::string_view, LayerKind>> all = {
      {"墙", LayerKind::Wall},        {"牆", LayerKind::Wall},       {"壁", LayerKind::Wall},
      {"柱", LayerKind::Wall},        {"门窗", LayerKind::Window},   {"窗", LayerKind::Window},
      {"窓", LayerKind::Window},      {"门", LayerKind::Door},       {"門", LayerKind::Door},
      {"扉", LayerKind::Door},        {"ドア", LayerKind::Door},     {"стен", LayerKind::Wall},
      {"Стен", LayerKind::Wall},      {"СТЕН", LayerKind::Wall},     {"перегород", LayerKind::Wall},
      {"колон", LayerKind::Wall},     {"окн", LayerKind::Window},    {"Окн", LayerKind::Window},
      {"двер", LayerKind::Door},      {"Двер", LayerKind::Door},     {"벽", LayerKind::Wall},
      {"جدار", LayerKind::Wall},      {"حائط", LayerKind::Wall},     {"جدران", LayerKind::Wall},
      {"باب", LayerKind::Door},       {"أبواب", LayerKind::Door},    {"شباك", LayerKind::Window},
      {"نافذ", LayerKind::Window},    {"أثاث", LayerKind::Other},    {"نص", LayerKind::Other},
      {"درج", LayerKind::Stairs},     {"קיר", LayerKind::Wall},      {"דלת", LayerKind::Door},
      {"דלתות", LayerKind::Door},     {"חלון", LayerKind::Window},   {"חלונות", LayerKind::Window},
      {"ריהוט", LayerKind::Other},    {"טקסט", LayerKind::Other},    {"מדרגות", LayerKind::Stairs},
      {"ΤΟΙΧ", LayerKind::Wall},      {"τοίχ", LayerKind::Wall},     {"Τοίχ", LayerKind::Wall},
      {"ΠΟΡΤ", LayerKind::Door},      {"πόρτ", LayerKind::Door},     {"ΠΑΡΑΘΥΡ", LayerKind::Window},
      {"παράθυρ", LayerKind::Window}, {"ΕΠΙΠΛ", LayerKind::Other},   {"έπιπλ", LayerKind::Other},
      {"ΚΕΙΜΕΝ", LayerKind::Other},   {"ΣΚΑΛ", LayerKind::Stairs},   {"벽체", LayerKind::Wall},
      {"문자", LayerKind::Other},     {"창문", LayerKind::Window},   {"창호", LayerKind::Window},
      {"문", LayerKind::Door},        {"가구", LayerKind::Other},    {"치수", LayerKind::Other},
      {"글자", LayerKind::Other},     {"계단", LayerKind::Stairs},   {"дверь", LayerKind::Door},
      {"ДВЕР", LayerKind::Door},      {"ОКН", LayerKind::Window},    {"Мебел", LayerKind::Other},
      {"МЕБЕЛ", LayerKind::Other},    {"Лестн", LayerKind::Stairs},  {"กำแพง", LayerKind::Wall},
      {"ผนัง", LayerKind::Wall},       {"ประตู", LayerKind::Door},     {"दीवार", LayerKind::Wall},
      {"दरवाज", LayerKind::Door},     {"楼梯", LayerKind::Stairs},   {"階段", LayerKind::Stairs},
      {"лестн", LayerKind::Stairs},   {"家具", LayerKind::Other},    {"标注", LayerKind::Other},
      {"文字", LayerKind::Other},     {"寸法", LayerKind::Other},    {"屋根", LayerKind::Other},
      {"мебел", LayerKind::Other},    {"グリッド", LayerKind::Other}};
  return all;
}

/// `xref-House$0$A-Wall_ext` -> a, wall, ext.
std::vector<std::string> words_in_name(std::string_view name) {
  const std::size_t bound = name.find_last_of("$|");
  if (bound != std::string_view::npos) name.remove_prefix(bound + 1);
  std::vector<std::string> out(1);
  for (std::size_t i = 0; i < name.size(); ++i) {
    const auto c = static_cast<unsigned char>(name[i]);
    if (c >= 0x80) continue;  // Umlauts and accents are dropped: "Wände" begins as "w nde".
    if (!std::isalpha(c))
      out.emplace_back();
    else {
      const bool hump =
          i > 0 && std::isupper(c) && std::islower(static_cast<unsigned char>(name[i - 1]));
      if (hump) out.emplace_back();
      out.back() += static_cast<char>(std::tolower(c));
    }
  }
  return out;
}

bool matches(std::string_view name, std::string_view pattern) {
  if (pattern.empty()) return false;
  const std::size_t star = pattern.find('*');
  if (star == std::string_view::npos) return lower_case(name) == lower_case(pattern);
  const std::string whole = lower_case(name), head = lower_case(pattern.substr(0, star)),
                    tail = lower_case(pattern.substr(star + 1));
  return whole.size() >= head.size() + tail.size() && whole.starts_with(head) &&
         whole.ends_with(tail);
}

}  // namespace

LayerKind kind_of_layer(std::string_view name) {
  for (const auto& [part, kind] : parts())
    if (name.find(part) != std::string_view::npos) return kind;
  const std::vector<std::string> own = words_in_name(name);
  for (const Words& group : words())
    for (const std::string& word : own)
      for (const std::string_view beginning : group.beginnings)
        if (word.starts_with(beginning) &&
            (beginning.size() > 3 || word.size() <= beginning.size() + 2))
          return group.kind;
  return LayerKind::Unknown;
}

LayerKind kind_of_layer(std::string_view name, const std::map<std::string, std::string>& by_kind) {
  static const std::map<std::string, LayerKind> kinds = {
      {"wall", LayerKind::Wall},      {"walls", LayerKind::Wall}, {"window", LayerKind::Window},
      {"windows", LayerKind::Window}, {"door", LayerKind::Door},  {"doors", LayerKind::Door},
      {"room", LayerKind::Room},      {"rooms", LayerKind::Room}, {"stairs", LayerKind::Stairs},
      {"other", LayerKind::Other}};
  bool walls_named = false;
  for (const auto& [kind, patterns] : by_kind) {
    const auto known = kinds.find(kind);
    if (known == kinds.end()) continue;
    walls_named =
        walls_named || known->second == LayerKind::Wall || known->second == LayerKind::Room;
    std::string_view rest = patterns;
    while (!rest.empty()) {
      const std::size_t comma = std::min(rest.find(','), rest.size());
      if (matches(name, rest.substr(0, comma))) return known->second;
      rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
  }
  return walls_named ? LayerKind::Other : kind_of_layer(name);
}

}  // namespace docent::import
