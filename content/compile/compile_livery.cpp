#include "content/compile/compile_livery.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "config/colour.h"
#include "content/compile/load_logo.h"
#include "content/compile/own_typefaces.h"
#include "content/content_error.h"
#include "runtime/scene/theme.h"

namespace docent::compile {
namespace {

std::string text_of(const scene::Colour& colour) {
  return fmt::format("#{:06X}", scene::hex_of(colour));
}

class LookReader {
 public:
  LookReader(const config::MuseumConfig& config, Museum& museum, Report& report)
      : config_(config), look_(config.look), museum_(museum), report_(report) {}

  void read_colours() {
    Livery& livery = museum_.livery;
    take(look_.paper, livery.paper);
    take(look_.ink, livery.ink);
    take(look_.accent, livery.accent);
    take(look_.focus, livery.focus);
    const scene::Theme theme = scene::day_theme(livery);
    if (scene::luminance(theme.paper) < scene::least_paper) {
      const scene::Colour lighter = scene::lifted(theme.paper, lightness_needed(theme));
      return error(look_.paper.place, "low-contrast",
                   fmt::format("'{}' is too dark for paper, on which ways have to be seen",
                               text_of(theme.paper)),
                   fmt::format("take a lighter one, such as \"{}\"; theme = \"night\" in "
                               "kiosk.toml is for halls in the dark",
                               text_of(lighter)));
    }
    check(look_.ink, "ink", theme.ink, theme.paper, scene::least_of_text);
    check(look_.accent, "accent", theme.invitation, theme.paper, scene::least_of_invitation);
    check(look_.focus, "focus", theme.focus, theme.paper, scene::least_of_focus);
  }

  void read_logos() {
    const Livery house = museum_.livery;
    auto day = load(look_.logo), night = load(look_.logo_at_night);
    if (night && !look_.logo.value.empty() && !day) return;  // told of
    if (night && !day)
      return error(look_.logo_at_night.place, "missing-field",
                   "there is a logo for the night, and none for the day",
                   "write logo = \"...\", too");
    if (!day) return;
    const scene::Theme light = scene::day_theme(house), dark = scene::night_theme(house);
    tell_of(look_.logo, *day, light.paper, "paper");
    museum_.livery.logo_shows_at_night = shows_on(*day, dark.paper);
    museum_.livery.logo = keep(*day);
    if (!night) return;
    tell_of(look_.logo_at_night, *night, dark.paper, "the dark paper of the night");
    museum_.livery.logo_at_night = keep(*night);
  }

 private:
  static void take(const config::Located<std::string>& written, std::uint32_t& colour) {
    if (written.given) colour = config::parse_colour(written.value).value_or(colour);
  }

  /// Of a paper on which docent's own colours, where no others are written, are told.
  float lightness_needed(const scene::Theme& theme) const {
    float needed = scene::least_paper;
    const auto add = [&](const config::Located<std::string>& written, const scene::Colour& colour,
                         float least) {
      if (!written.given)
        needed = std::max(needed, least * (scene::luminance(colour) + 0.05F) - 0.05F);
    };
    add(look_.ink, theme.ink, scene::least_of_text);
    add(look_.accent, theme.invitation, scene::least_of_invitation);
    add(look_.focus, theme.focus, scene::least_of_focus);
    constexpr float a_little_more = 0.01F;  // for the eight bits that it is written in
    return std::min(1.0F, needed + a_little_more);
  }

  void error(const config::Place& place, std::string code, std::string message, std::string hint) {
    report_.add(config::diagnostic_at(config_, place, std::move(code), std::move(message), {},
                                      std::move(hint)));
  }
  void warning(const config::Place& place, std::string code, std::string message,
               std::string hint) {
    Diagnostic diagnostic = config::diagnostic_at(config_, place, std::move(code),
                                                  std::move(message), {}, std::move(hint));
    diagnostic.severity = Severity::Warning;
    report_.add(std::move(diagnostic));
  }

  /// A colour that is not written is docent's own, and then it is the paper that it does not suit.
  void check(const config::Located<std::string>& written, std::string_view name,
             const scene::Colour& colour, const scene::Colour& paper, float least) {
    const float told = scene::contrast(colour, paper);
    const float light = scene::luminance(paper);
    if (told >= least && scene::luminance(colour) < light) return;
    // A little darker than it need be, for the eight bits that it is written in.
    const float most = 0.97F * ((light + 0.05F) / least - 0.05F);
    error(written.given ? written.place : look_.paper.place, "low-contrast",
          fmt::format("the {} '{}' is told from the paper '{}' by {:.1f}:1, and has to be by "
                      "{:.0f}:1",
                      name, text_of(colour), text_of(paper), told, least),
          fmt::format("take a darker one, such as {} = \"{}\"", name,
                      text_of(scene::deepened(colour, most))));
  }

  std::optional<Logo> load(const config::Located<std::string>& written) {
    if (!written.given || written.value.empty()) return {};
    try {
      return load_logo(config_.folder / written.value, written.value);
    } catch (const content::ContentError& fault) {
      error(written.place, fault.code, fmt::format("'{}': {}", written.value, fault.what()),
            fault.hint);
      return {};
    }
  }

  void tell_of(const config::Located<std::string>& written, const Logo& logo,
               const scene::Colour& paper, std::string_view name) {
    constexpr float of_a_sign = 3;  // a ground that is as clear as that is meant
    if (logo.ground && text_of(*logo.ground) != text_of(paper) &&
        scene::contrast(*logo.ground, paper) < of_a_sign)
      warning(written.place, "logo-ground",
              fmt::format("'{}' has a ground of its own, '{}', which is seen on {}", written.value,
                          text_of(*logo.ground), name),
              "take an SVG, or a PNG in which nothing lies behind the sign");
    else if (!shows_on(logo, paper))
      warning(written.place, "logo-pale",
              fmt::format("'{}' is hardly told from {}, '{}'", written.value, name, text_of(paper)),
              "take a darker one for the day, a lighter one for the night");
  }

  std::uint32_t keep(Logo& logo) {
    museum_.images.push_back(std::move(logo.image));
    return static_cast<std::uint32_t>(museum_.images.size() - 1);
  }

  const config::MuseumConfig& config_;
  const config::LookSection& look_;
  Museum& museum_;
  Report& report_;
};

}  // namespace

void compile_livery(const config::MuseumConfig& config, Museum& museum, Report& report) {
  LookReader reader(config, museum, report);
  reader.read_colours();
  reader.read_logos();
  read_typefaces(config, museum, report);
}

}  // namespace docent::compile
