#include "content/compile/linked_pictures.h"

#include <algorithm>

namespace docent::compile {

namespace {

/// The value of `href` in an element's text; empty where there is none.
std::string_view href_of(std::string_view element) {
  std::size_t at = element.find("href");
  if (at == std::string_view::npos) return {};
  at = element.find_first_of("\"'", at);
  if (at == std::string_view::npos) return {};
  const std::size_t end = element.find(element[at], at + 1);
  return end == std::string_view::npos ? std::string_view{} : element.substr(at + 1, end - at - 1);
}

}  // namespace

std::vector<std::string> linked_pictures(std::string_view svg) {
  std::vector<std::string> links;
  for (std::size_t at = svg.find("<image"); at != std::string_view::npos;
       at = svg.find("<image", at + 1)) {
    const std::string_view href = href_of(svg.substr(at, svg.find('>', at) - at));
    if (href.empty() || href.starts_with("data:") || href.starts_with('#')) continue;
    links.emplace_back(href.substr(0, std::min<std::size_t>(href.size(), 100)));
  }
  return links;
}

}  // namespace docent::compile
