#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace docent::avatar {

/// What grows on a head.
enum class Hair : std::uint8_t { Short, Bun, Curls, Long, None };
/// What is worn on it.
enum class Headwear : std::uint8_t { None, Scarf, Turban, Cap };
/// What is worn over the body.
enum class Garment : std::uint8_t {
  Coat,
  Dress,
  Kurta,
  Abaya,
  Jacket,
  Cardigan,
  Uniform,
  Tunic,
};

/// How a face departs from the one that head.cpp measures: shares of its size, around 1.
struct Face {
  float width = 1;  ///< Of cheekbones and jaw.
  float jaw = 1;    ///< Of the jaw's corners and the chin.
  float brow = 1;   ///< How far the ridge above the eyes stands out.
  float nose = 1;   ///< Length and breadth.
  float lips = 1;   ///< Fullness.
  float age = 0;    ///< 0 to 1: folds beside the mouth, under the eyes, hollow cheeks.
  float beard = 0;  ///< Metres that it hangs below the chin; 0: shaved.
};

/// How a trunk departs from the one that trunk.cpp measures.
struct Build {
  float shoulders = 1, chest = 1, waist = 1, hips = 1;  ///< Shares of width.
  float belly = 0, bust = 0;                            ///< Metres that they stand out.
  float neck = 1;                                       ///< Share of girth.
};

/// One guide: everything that tells its silhouette from the others'. Colours are the look's
/// (runtime/scene/look.h).
struct Figure {
  std::string_view name;
  Hair hair = Hair::Short;
  Headwear headwear = Headwear::None;
  Garment garment = Garment::Coat;
  Face face{};
  Build build{};
};

/// One for each guide's look, in their order.
inline constexpr std::array<Figure, 8> figures{{
    {.name = "teal", .hair = Hair::Short, .garment = Garment::Coat},
    {.name = "vermilion",
     .hair = Hair::Bun,
     .garment = Garment::Dress,
     .face = {.width = 0.95F, .jaw = 0.88F, .brow = 0.4F, .nose = 0.9F, .lips = 1.15F},
     .build = {.shoulders = 0.93F,
               .chest = 0.95F,
               .waist = 0.86F,
               .hips = 1.02F,
               .bust = 0.028F,
               .neck = 0.86F}},
    {.name = "saffron",
     .hair = Hair::None,
     .headwear = Headwear::Turban,
     .garment = Garment::Kurta,
     .face = {.nose = 1.08F, .age = 0.5F, .beard = 0.035F}},
    {.name = "navy",
     .hair = Hair::Short,
     .headwear = Headwear::Cap,
     .garment = Garment::Uniform,
     .face = {.width = 1.03F, .jaw = 1.1F, .brow = 1.2F},
     .build = {.shoulders = 1.08F, .chest = 1.06F, .waist = 1.04F, .neck = 1.08F}},
    {.name = "sky",
     .hair = Hair::Curls,
     .garment = Garment::Jacket,
     .face = {.nose = 1.05F, .lips = 1.3F}},
    {.name = "rose",
     .hair = Hair::Long,
     .garment = Garment::Tunic,
     .face = {.width = 0.95F, .jaw = 0.86F, .brow = 0.35F, .nose = 0.88F, .lips = 1.2F},
     .build = {.shoulders = 0.92F, .chest = 0.94F, .waist = 0.86F, .bust = 0.026F, .neck = 0.85F}},
    {.name = "ivory",
     .hair = Hair::None,
     .garment = Garment::Cardigan,
     .face = {.width = 1.06F, .jaw = 1.08F, .nose = 1.15F, .age = 1, .beard = 0.022F},
     .build = {.shoulders = 1.08F,
               .chest = 1.1F,
               .waist = 1.22F,
               .hips = 1.1F,
               .belly = 0.05F,
               .neck = 1.1F}},
    {.name = "plum",
     .headwear = Headwear::Scarf,
     .garment = Garment::Abaya,
     .face = {.width = 0.96F, .jaw = 0.88F, .brow = 0.4F, .nose = 0.95F, .lips = 1.1F},
     .build = {.shoulders = 0.94F, .waist = 0.92F, .hips = 1.04F, .bust = 0.02F, .neck = 0.88F}},
}};

}  // namespace docent::avatar
