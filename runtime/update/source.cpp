#include "runtime/update/source.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

namespace docent::update {
namespace {

using https::Response;

Result<Response> read(const std::filesystem::path& file, std::uint64_t most,
                      const std::function<bool(std::span<const std::byte>)>& take) {
  const auto failed = [&](std::string_view why) {
    return std::unexpected(
        Error{Errc::Environment, fmt::format("{}: {}; what is shown stays", file.string(), why)});
  };
  std::error_code status;
  const bool is_there = std::filesystem::exists(file, status);
  if (status) return failed(fmt::format("cannot be looked at ({})", status.message()));
  if (!is_there) return Response{.kind = Response::Kind::NotFound};
  if (!std::filesystem::is_regular_file(file, status)) return failed("is not a file");
  std::ifstream in(file, std::ios::binary);
  if (!in) return failed("may not be read; give it read permission: chmod a+r");
  std::array<char, 65536> part;
  while (in) {
    in.read(part.data(), part.size());
    const auto size = static_cast<std::size_t>(in.gcount());
    if (size > most) return failed("is larger than its release says");
    most -= size;
    if (size > 0 && !take(std::as_bytes(std::span(part).first(size))))
      return failed("cannot be copied");
  }
  if (in.bad()) return failed("cannot be read to its end");
  return Response{};
}

}  // namespace

bool is_url(const Source& source) {
  return source.place.starts_with("https://") || source.place.starts_with("http://");
}

std::string name_in(const Source& source, std::string_view name) {
  return source.place.ends_with('/') ? fmt::format("{}{}", source.place, name)
                                     : fmt::format("{}/{}", source.place, name);
}

Result<Response> fetch(const Source& source, std::string_view name, std::uint64_t most,
                       const std::string& etag,
                       const std::function<bool(std::span<const std::byte>)>& take) {
  const std::string file = name_in(source, name);
  return is_url(source)
             ? https::fetch({.url = file, .etag = etag, .most = most, .session = source.session},
                            take)
             : read(file, most, take);
}

Result<Text> fetch_text(const Source& source, std::string_view name, std::uint64_t most,
                        const std::string& etag) {
  Text text;
  const auto take = [&](std::span<const std::byte> bytes) {
    text.bytes.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return true;
  };
  Result<Response> response = fetch(source, name, most, etag, take);
  if (!response) return std::unexpected(response.error());
  text.response = std::move(*response);
  return text;
}

}  // namespace docent::update
