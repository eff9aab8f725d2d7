#include "content/compile/found.h"

#include <fmt/format.h>

#include <algorithm>

namespace docent::compile {

std::vector<std::pair<std::string_view, std::size_t>> found_in(const Museum& museum) {
  std::size_t doors = 0;
  for (const Floor& floor : museum.floors) doors += floor.plan.doors.size();
  return {{"exhibits", museum.exhibits.size()},
          {"rooms", museum.rooms.size()},
          {"doors", doors},
          {"floors", museum.floors.size()},
          {"places", museum.places.size()},
          {"connections", museum.connections.size()},
          {"languages", museum.languages.size()}};
}

std::size_t undescribed_pictures(const Museum& museum) {
  const auto own = std::ranges::count_if(museum.exhibits, [&](const Exhibit& exhibit) {
    return has_picture(museum, exhibit) && exhibit.description.empty();
  });
  const auto further = std::ranges::count_if(
      museum.pictures, [](const FurtherPicture& one) { return one.description.empty(); });
  return static_cast<std::size_t>(own + further);
}

std::string found_text(const Museum& museum, const Museum* before) {
  const auto now = found_in(museum);
  const auto then = before == nullptr ? now : found_in(*before);
  std::vector<std::string> parts;
  for (std::size_t i = 0; i < now.size(); ++i) {
    std::string_view name = now[i].first;
    if (now[i].second == 1) name.remove_suffix(1);
    parts.push_back(fmt::format("{} {}", now[i].second, name));
    if (now[i].second != then[i].second)
      parts.back() += fmt::format(" ({} before)", then[i].second);
  }
  std::string text = fmt::format("{}", fmt::join(parts, ", "));
  if (const std::size_t count = undescribed_pictures(museum); count == 1)
    text += "; 1 picture has no description";
  else if (count > 1)
    text += fmt::format("; {} pictures have no description", count);
  return text;
}

}  // namespace docent::compile
