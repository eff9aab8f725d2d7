#include "platform/pango/text_setter.h"

#include <pango/pangocairo.h>
#include <pango/pangofc-fontmap.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <thread>
#include <utility>

#include "platform/handle.h"
#include "platform/pango/own_fonts.h"

namespace docent::pango {
namespace {

using FontMap = std::unique_ptr<PangoFontMap, CloseWith<g_object_unref>>;
using Context = std::unique_ptr<PangoContext, CloseWith<g_object_unref>>;
using Layout = std::unique_ptr<PangoLayout, CloseWith<g_object_unref>>;
using Font = std::unique_ptr<PangoFontDescription, CloseWith<pango_font_description_free>>;
using FontOptions = std::unique_ptr<cairo_font_options_t, CloseWith<cairo_font_options_destroy>>;
using Surface = std::unique_ptr<cairo_surface_t, CloseWith<cairo_surface_destroy>>;
using Cairo = std::unique_ptr<cairo_t, CloseWith<cairo_destroy>>;

/// Far beyond any screen: a text that would need more is set into this much.
constexpr int most_pixels = 8192;

/// Type is designed for blending in sRGB; blended in linear light, dark letters on paper come out
/// thin. This gives their edges back what they lose: coverage to the power 0.74, which is half way
/// between the two (1 / 2.2 would overdo it for light letters on dark buttons).
const std::array<std::uint8_t, 256> strengthened = [] {
  std::array<std::uint8_t, 256> curve{};
  for (std::size_t i = 0; i < curve.size(); ++i)
    curve[i] =
        static_cast<std::uint8_t>(std::lround(255 * std::pow(static_cast<double>(i) / 255, 0.74)));
  return curve;
}();

/// The house's two families and their companions. Pango takes what is missing from the next.
const char* families(const interface::TextStyle& style) {
  const bool serif = style.family == interface::Family::Serif;
  if (style.language.starts_with("zh"))
    return serif ? "Noto Serif CJK SC, Noto Serif" : "Noto Sans CJK SC, Inter, Noto Sans";
  if (style.language.starts_with("ja"))
    return serif ? "Noto Serif CJK JP, Noto Serif" : "Noto Sans CJK JP, Inter, Noto Sans";
  if (style.language.starts_with("ko"))
    return serif ? "Noto Serif CJK KR, Noto Serif" : "Noto Sans CJK KR, Inter, Noto Sans";
  if (style.right_to_left)
    return serif ? "Noto Naskh Arabic, Noto Serif" : "Noto Sans Arabic, Inter, Noto Sans";
  return serif ? "Noto Serif" : "Inter, Noto Sans";
}

/// In these a line may end after any character.
bool breaks_anywhere(std::string_view language) {
  return language.starts_with("ja") || language.starts_with("zh") || language.starts_with("ko");
}

/// The bytes from which on a paragraph stays together, so that its last character never stands
/// alone on a line: its last two, and the signs after them.
std::size_t last_two(std::string_view paragraph) {
  const char* begin = paragraph.data();
  const char* end = begin + paragraph.size();
  const char* at = end;
  for (int letters = 0; letters < 2;) {
    at = g_utf8_find_prev_char(begin, at);
    if (at == nullptr) return 0;
    letters += g_unichar_isalnum(g_utf8_get_char_validated(at, end - at)) != FALSE ? 1 : 0;
  }
  return static_cast<std::size_t>(at - begin);
}

void keep_ends_together(std::string_view text, PangoAttrList* attributes) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    PangoAttribute* together = pango_attr_allow_breaks_new(FALSE);
    together->start_index = static_cast<guint>(at + last_two(text.substr(at, end - at)));
    together->end_index = static_cast<guint>(end);
    pango_attr_list_insert(attributes, together);
    at = end + 1;
  }
}

/// Which letters a museum brings along, by language.
struct OwnFamilies {
  std::map<std::string, std::string, std::less<>> titles, text;

  /// The house's families, after the museum's own where it has one.
  std::string before(const interface::TextStyle& style) const {
    const auto& own = style.family == interface::Family::Serif ? titles : text;
    const auto found = own.find(style.language);
    return found == own.end() ? families(style) : found->second + ", " + families(style);
  }
};

std::map<std::string, std::string, std::less<>> families_of(const Typeface& typeface,
                                                            const Museum& museum) {
  std::map<std::string, std::string, std::less<>> families;
  for (const std::uint32_t language : typeface.languages)
    if (language < museum.languages.size())
      families.emplace(museum.languages[language].tag, typeface.family);
  return families;
}

/// How many font maps there are: Pango looks for fonts on a thread of its own, which keeps a map
/// for as long as it looks.
std::atomic<int> font_maps;

FontMap open_font_map() {
  FontMap fonts(pango_cairo_font_map_new());
  if (!fonts) return fonts;
  ++font_maps;
  g_object_set_data_full(G_OBJECT(fonts.get()), "docent", &font_maps,
                         [](gpointer) { --font_maps; });
  return fonts;
}

/// Waits until no font map is left; false where one stays.
bool font_maps_have_gone() {
  constexpr std::chrono::milliseconds step{1}, patience{1000};
  for (std::chrono::milliseconds waited{0}; waited < patience; waited += step) {
    if (font_maps == 0) return true;
    std::this_thread::sleep_for(step);
  }
  return false;
}

/// Fonts, and what has been learnt of them.
class TextSetter {
 public:
  TextSetter() { open_fonts(); }

  bool has_fonts() {
    const std::lock_guard lock(one_at_a_time_);
    PangoFontFamily** all = nullptr;
    int count = 0;
    if (fonts_) pango_font_map_list_families(fonts_.get(), &all, &count);
    g_free(static_cast<void*>(all));
    return count > 0;
  }

  /// Sets with a museum's fonts from now on.
  void take(std::span<const FontFile> files) {
    const std::lock_guard lock(one_at_a_time_);
    if (own_.take(files)) open_anew();
  }

  interface::TextBitmap set(const interface::TextStyle& style, const std::string& families,
                            std::string_view text, std::uint32_t width) {
    const std::lock_guard lock(one_at_a_time_);
    ++texts_;
    const Layout layout = lay_out(style, families, text, width);
    return style.line_count == 0 ? draw(layout.get())
                                 : draw_lines(layout.get(), style.first_line, style.line_count);
  }

  /// Cairo gives back what it keeps of fonts (every letter, in every size and at every quarter of a
  /// pixel, 1.6 KB each, up to 16,384) only where nothing of it is in use.
  void forget() {
    const std::lock_guard lock(one_at_a_time_);
    if (texts_ >= many_texts) open_anew();
  }

 private:
  void open_anew() {
    texts_ = 0;
    context_.reset();
    fonts_.reset();
    if (font_maps_have_gone()) cairo_debug_reset_static_data();
    open_fonts();
  }

  void open_fonts() {
    fonts_ = open_font_map();
    if (!fonts_) return;
    if (own_.config() != nullptr)
      pango_fc_font_map_set_config(PANGO_FC_FONT_MAP(fonts_.get()), own_.config());
    context_.reset(pango_font_map_create_context(fonts_.get()));
    // Letters are placed and drawn as designed, so that a text looks the same on every machine.
    const FontOptions options(cairo_font_options_create());
    cairo_font_options_set_antialias(options.get(), CAIRO_ANTIALIAS_GRAY);
    cairo_font_options_set_hint_style(options.get(), CAIRO_HINT_STYLE_NONE);
    cairo_font_options_set_hint_metrics(options.get(), CAIRO_HINT_METRICS_OFF);
    pango_cairo_context_set_font_options(context_.get(), options.get());
    pango_context_set_round_glyph_positions(context_.get(), FALSE);
  }

  Layout lay_out(const interface::TextStyle& style, const std::string& families,
                 std::string_view text, std::uint32_t width) const {
    const std::string language(style.language);
    pango_context_set_language(context_.get(), pango_language_from_string(language.c_str()));
    pango_context_set_base_dir(context_.get(),
                               style.right_to_left ? PANGO_DIRECTION_RTL : PANGO_DIRECTION_LTR);

    const Font font(pango_font_description_new());
    pango_font_description_set_family(font.get(), families.c_str());
    pango_font_description_set_weight(font.get(), static_cast<PangoWeight>(style.weight));
    pango_font_description_set_absolute_size(font.get(), style.size * PANGO_SCALE);

    Layout layout(pango_layout_new(context_.get()));
    pango_layout_set_font_description(layout.get(), font.get());
    pango_layout_set_text(layout.get(), text.data(), static_cast<int>(text.size()));
    if (width > 0)
      pango_layout_set_width(layout.get(),
                             std::min(static_cast<int>(width), most_pixels) * PANGO_SCALE);
    // Lines begin at the side where the language begins; Pango turns this round by itself only for
    // paragraphs that run against the base direction.
    pango_layout_set_alignment(layout.get(), style.centred         ? PANGO_ALIGN_CENTER
                                             : style.right_to_left ? PANGO_ALIGN_RIGHT
                                                                   : PANGO_ALIGN_LEFT);
    pango_layout_set_wrap(layout.get(), PANGO_WRAP_WORD_CHAR);
    if (style.max_lines > 0) {
      pango_layout_set_ellipsize(layout.get(), PANGO_ELLIPSIZE_END);
      pango_layout_set_height(layout.get(), -static_cast<int>(style.max_lines));
    }

    PangoAttrList* attributes = pango_attr_list_new();
    pango_attr_list_insert(attributes,
                           pango_attr_line_height_new_absolute(static_cast<int>(
                               std::round(style.size * style.line_height) * PANGO_SCALE)));
    if (style.tabular) pango_attr_list_insert(attributes, pango_attr_font_features_new("tnum=1"));
    if (breaks_anywhere(style.language)) keep_ends_together(text, attributes);
    pango_layout_set_attributes(layout.get(), attributes);
    pango_attr_list_unref(attributes);
    return layout;
  }

  static interface::TextBitmap draw(PangoLayout* layout) {
    PangoRectangle ink, logical;
    pango_layout_get_pixel_extents(layout, &ink, &logical);
    // Some letters reach out of their advance width or, where lines are close, out of their line;
    // nothing of them is cut off. Above and below the same room is added, so that a line stays in
    // the middle of its place.
    const int left = std::min(ink.x, logical.x);
    const int right = std::max(ink.x + ink.width, logical.x + logical.width);
    const int overhang =
        std::max({logical.y - ink.y, ink.y + ink.height - (logical.y + logical.height), 0});
    interface::TextBitmap bitmap;
    bitmap.lines = static_cast<std::uint32_t>(pango_layout_get_line_count(layout));
    bitmap.cut = pango_layout_is_ellipsized(layout) != FALSE;
    bitmap.width = static_cast<std::uint32_t>(std::clamp(right - left, 0, most_pixels));
    bitmap.height =
        static_cast<std::uint32_t>(std::clamp(logical.height + 2 * overhang, 0, most_pixels));
    if (bitmap.width == 0 || bitmap.height == 0) return bitmap;

    const int stride =
        cairo_format_stride_for_width(CAIRO_FORMAT_A8, static_cast<int>(bitmap.width));
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(stride) * bitmap.height);
    const Surface surface(cairo_image_surface_create_for_data(
        rows.data(), CAIRO_FORMAT_A8, static_cast<int>(bitmap.width),
        static_cast<int>(bitmap.height), stride));
    const Cairo cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -left, overhang - logical.y);
    pango_cairo_show_layout(cairo.get(), layout);
    cairo_surface_flush(surface.get());

    take_coverage(rows, static_cast<std::size_t>(stride), bitmap);
    return bitmap;
  }

  /// Some lines of a long text, which may be higher than any texture.
  static interface::TextBitmap draw_lines(PangoLayout* layout, int first, int count) {
    PangoRectangle ink, logical;
    pango_layout_get_pixel_extents(layout, &ink, &logical);
    const int left = std::min(ink.x, logical.x);
    const int right = std::max(ink.x + ink.width, logical.x + logical.width);
    const int lines = pango_layout_get_line_count(layout);
    interface::TextBitmap bitmap;
    bitmap.lines = static_cast<std::uint32_t>(lines);
    const int end = std::min(lines, first + count);
    if (first >= end) return bitmap;
    const int line = logical.height / lines;
    bitmap.width = static_cast<std::uint32_t>(std::clamp(right - left, 0, most_pixels));
    bitmap.height = static_cast<std::uint32_t>(std::clamp((end - first) * line, 0, most_pixels));
    if (bitmap.width == 0 || bitmap.height == 0) return bitmap;
    const int stride =
        cairo_format_stride_for_width(CAIRO_FORMAT_A8, static_cast<int>(bitmap.width));
    std::vector<std::uint8_t> rows(static_cast<std::size_t>(stride) * bitmap.height);
    const Surface surface(cairo_image_surface_create_for_data(
        rows.data(), CAIRO_FORMAT_A8, static_cast<int>(bitmap.width),
        static_cast<int>(bitmap.height), stride));
    const Cairo cairo(cairo_create(surface.get()));
    cairo_translate(cairo.get(), -left, -logical.y - first * line);
    pango_cairo_show_layout(cairo.get(), layout);
    cairo_surface_flush(surface.get());
    take_coverage(rows, static_cast<std::size_t>(stride), bitmap);
    return bitmap;
  }

  static void take_coverage(const std::vector<std::uint8_t>& rows, std::size_t stride,
                            interface::TextBitmap& bitmap) {
    bitmap.coverage.resize(std::size_t{bitmap.width} * bitmap.height);
    for (std::uint32_t y = 0; y < bitmap.height; ++y)
      std::transform(rows.begin() + static_cast<std::ptrdiff_t>(y * stride),
                     rows.begin() + static_cast<std::ptrdiff_t>(y * stride + bitmap.width),
                     bitmap.coverage.begin() + static_cast<std::ptrdiff_t>(y) * bitmap.width,
                     [](std::uint8_t coverage) { return strengthened[coverage]; });
  }

  static constexpr std::size_t many_texts = 25;

  std::mutex one_at_a_time_;
  OwnFonts own_;
  FontMap fonts_;
  Context context_;
  std::size_t texts_ = 0;  ///< Set since the fonts were opened.
};

/// The one of the process, while somebody uses it: Cairo keeps what it learns for the process.
std::shared_ptr<TextSetter> text_setter(bool make) {
  static std::mutex guard;
  static std::weak_ptr<TextSetter> living;
  const std::lock_guard lock(guard);
  std::shared_ptr<TextSetter> setter = living.lock();
  if (!setter && make) living = setter = std::make_shared<TextSetter>();
  return setter;
}

}  // namespace

Result<interface::SetText> make_text_setter(const Museum* museum) {
  const std::shared_ptr<TextSetter> setter = text_setter(true);
  OwnFamilies own;
  if (museum != nullptr) {
    setter->take(museum->fonts);
    own = {families_of(museum->livery.titles, *museum), families_of(museum->livery.text, *museum)};
  }
  if (!setter->has_fonts())
    return std::unexpected(Error{Errc::Environment,
                                 "no fonts are installed: install fonts-inter, fonts-noto-core and "
                                 "fonts-noto-cjk"});
  return [setter, own = std::move(own)](const interface::TextStyle& style, std::string_view text,
                                        std::uint32_t width) {
    return setter->set(style, own.before(style), text, width);
  };
}

void forget_letters() {
  if (const std::shared_ptr<TextSetter> setter = text_setter(false)) setter->forget();
}

}  // namespace docent::pango
