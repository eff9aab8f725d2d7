#include "runtime/interface/plural.h"

#include <algorithm>

namespace docent::interface {
namespace {

constexpr bool is_within(long number, long least, long most) noexcept {
  return number >= least && number <= most;
}

/// A number, and its last digit and last two.
struct Number {
  constexpr explicit Number(long number) noexcept
      : n(number), ten(number % 10), hundred(number % 100) {}
  constexpr bool is_teen() const noexcept { return is_within(hundred, 11, 19); }
  constexpr bool is_twelve_to_fourteen() const noexcept { return is_within(hundred, 12, 14); }
  long n, ten, hundred;
};

using Rule = std::string_view (*)(Number) noexcept;

std::string_view always_other(Number /*all*/) noexcept {
  return "other";
}
std::string_view one(Number i) noexcept {
  return i.n == 1 ? "one" : "other";
}
std::string_view none_and_one(Number i) noexcept {
  return i.n <= 1 ? "one" : "other";
}
std::string_view one_two(Number i) noexcept {
  return i.n == 1 ? "one" : i.n == 2 ? "two" : "other";
}
std::string_view arabic(Number i) noexcept {
  if (i.n <= 2) return plural_forms[static_cast<std::size_t>(i.n)];
  if (is_within(i.hundred, 3, 10)) return "few";
  return i.hundred >= 11 ? "many" : "other";
}
std::string_view breton(Number i) noexcept {
  const auto is_of = [&](long tens) { return i.hundred / 10 == tens; };
  if (i.ten == 1 && !is_of(1) && !is_of(7) && !is_of(9)) return "one";
  if (i.ten == 2 && !is_of(1) && !is_of(7) && !is_of(9)) return "two";
  if ((i.ten == 3 || i.ten == 4 || i.ten == 9) && !is_of(1) && !is_of(7) && !is_of(9)) return "few";
  return "other";
}
std::string_view cornish(Number i) noexcept {
  const auto is_any = [&](std::initializer_list<long> all) {
    return std::ranges::find(all, i.hundred) != all.end();
  };
  const long thousand = i.n % 100'000;
  if (i.n == 0) return "zero";
  if (i.n == 1) return "one";
  if (is_any({2, 22, 42, 62, 82}) ||
      (i.n % 1000 == 0 && (is_within(thousand, 1000, 20'000) || thousand == 40'000 ||
                           thousand == 60'000 || thousand == 80'000)) ||
      (i.n != 0 && i.n % 1'000'000 == 100'000))
    return "two";
  if (is_any({3, 23, 43, 63, 83})) return "few";
  return is_any({1, 21, 41, 61, 81}) ? "many" : "other";
}
std::string_view czech(Number i) noexcept {
  return i.n == 1 ? "one" : is_within(i.n, 2, 4) ? "few" : "other";
}
std::string_view filipino(Number i) noexcept {
  return i.ten == 4 || i.ten == 6 || i.ten == 9 ? "other" : "one";
}
std::string_view icelandic(Number i) noexcept {
  return i.ten == 1 && i.hundred != 11 ? "one" : "other";
}
std::string_view irish(Number i) noexcept {
  if (i.n == 1 || i.n == 2) return one_two(i);
  return is_within(i.n, 3, 6) ? "few" : is_within(i.n, 7, 10) ? "many" : "other";
}
std::string_view latvian(Number i) noexcept {
  if (i.ten == 0 || i.is_teen()) return "zero";
  return icelandic(i);
}
std::string_view lithuanian(Number i) noexcept {
  if (i.is_teen() || i.ten == 0) return "other";
  return i.ten == 1 ? "one" : "few";
}
std::string_view maltese(Number i) noexcept {
  if (i.n == 1 || i.n == 2) return one_two(i);
  if (i.n == 0 || is_within(i.hundred, 3, 10)) return "few";
  return i.is_teen() ? "many" : "other";
}
std::string_view manx(Number i) noexcept {
  if (i.ten == 1 || i.ten == 2) return i.ten == 1 ? "one" : "two";
  return i.hundred % 20 == 0 ? "few" : "other";
}
std::string_view none_one(Number i) noexcept {
  return i.n == 0 ? "zero" : one(i);
}
std::string_view polish(Number i) noexcept {
  if (i.n == 1) return "one";
  return is_within(i.ten, 2, 4) && !i.is_twelve_to_fourteen() ? "few" : "many";
}
std::string_view romanian(Number i) noexcept {
  if (i.n == 1) return "one";
  return i.n == 0 || is_within(i.hundred, 1, 19) ? "few" : "other";
}
std::string_view russian(Number i) noexcept {
  if (i.ten == 1 && i.hundred != 11) return "one";
  return is_within(i.ten, 2, 4) && !i.is_twelve_to_fourteen() ? "few" : "many";
}
std::string_view scottish(Number i) noexcept {
  if (i.n == 1 || i.n == 11) return "one";
  if (i.n == 2 || i.n == 12) return "two";
  return is_within(i.n, 3, 19) ? "few" : "other";
}
std::string_view serbian(Number i) noexcept {
  const std::string_view form = russian(i);
  return form == "many" ? "other" : form;
}
std::string_view slovenian(Number i) noexcept {
  if (i.hundred == 1 || i.hundred == 2) return i.hundred == 1 ? "one" : "two";
  return i.hundred == 3 || i.hundred == 4 ? "few" : "other";
}
std::string_view tachelhit(Number i) noexcept {
  return i.n <= 1 ? "one" : i.n <= 10 ? "few" : "other";
}
std::string_view tamazight(Number i) noexcept {
  return i.n <= 1 || is_within(i.n, 11, 99) ? "one" : "other";
}
std::string_view welsh(Number i) noexcept {
  if (i.n <= 2) return plural_forms[static_cast<std::size_t>(i.n)];
  return i.n == 3 ? "few" : i.n == 6 ? "many" : "other";
}

/// What speaks so, parted by blanks.
struct Speakers {
  std::string_view languages;
  Rule rule;
};
constexpr std::array speakers{
    Speakers{"bm bo dz hnj id ig ii in ja jbo jv jw kde kea km ko lkt lo ms my nqo osa sah ses sg "
             "su th to tpi vi wo yo yue zh",
             always_other},
    Speakers{"ak am as bho bn doi fa ff fr gu guw hi hy kab kn ln mg nso pa pcm pt si ti wa zu",
             none_and_one},
    Speakers{"he iu iw naq sat se sma smi smj smn sms", one_two},
    Speakers{"ar ars", arabic},
    Speakers{"br", breton},
    Speakers{"kw", cornish},
    Speakers{"cs sk", czech},
    Speakers{"ceb fil tl", filipino},
    Speakers{"is mk", icelandic},
    Speakers{"ga", irish},
    Speakers{"lv prg", latvian},
    Speakers{"lt", lithuanian},
    Speakers{"mt", maltese},
    Speakers{"gv", manx},
    Speakers{"ksh lag", none_one},
    Speakers{"pl", polish},
    Speakers{"mo ro", romanian},
    Speakers{"be ru uk", russian},
    Speakers{"gd", scottish},
    Speakers{"bs hr sh sr", serbian},
    Speakers{"dsb hsb sl", slovenian},
    Speakers{"shi", tachelhit},
    Speakers{"tzm", tamazight},
    Speakers{"cy", welsh}};

bool speaks(std::string_view languages, std::string_view language) noexcept {
  for (std::size_t at = languages.find(language); at != std::string_view::npos;
       at = languages.find(language, at + 1)) {
    const std::size_t end = at + language.size();
    if ((at == 0 || languages[at - 1] == ' ') && (end == languages.size() || languages[end] == ' '))
      return true;
  }
  return false;
}

}  // namespace

std::string_view plural_form(std::string_view tag, long number) noexcept {
  // Of Portugal's Portuguese nothing is one but one.
  if (tag.starts_with("pt-PT")) return one(Number(number));
  const std::string_view language = tag.substr(0, tag.find_first_of("-_"));
  const auto* known = std::ranges::find_if(
      speakers, [&](const Speakers& each) { return speaks(each.languages, language); });
  return (known == speakers.end() ? one : known->rule)(Number(number));
}

}  // namespace docent::interface
