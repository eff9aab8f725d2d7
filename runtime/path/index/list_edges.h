#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace docent::path {

/// Lists, for each of `count` things, the edges that end there: those of thing i are
/// list[first[i] .. first[i + 1]), ascending. `ends(edge)` gives a range of things; what is not one
/// of the `count` is passed over.
template <class Ends>
void list_edges(std::size_t count, std::size_t edges, Ends ends, std::vector<std::uint32_t>& first,
                std::vector<std::uint32_t>& list) {
  first.assign(count + 1, 0);
  for (std::uint32_t e = 0; e < edges; ++e)
    for (const std::uint32_t end : ends(e))
      if (end < count) ++first[end + 1];
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  list.resize(first.back());
  std::vector<std::uint32_t> fill(first.begin(), first.end() - 1);
  for (std::uint32_t e = 0; e < edges; ++e)
    for (const std::uint32_t end : ends(e))
      if (end < count) list[fill[end]++] = e;
}

}  // namespace docent::path
