#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "platform/https/fetch.h"
#include "runtime/model/result.h"

namespace docent::update {

/// Where releases come from: a folder, such as a USB stick's, or the URL of one.
struct Source {
  std::string place{};
  std::filesystem::path session{};  ///< Where a server's TLS session is kept; may be empty.
};

bool is_url(const Source& source);

/// A file's name with its place, for sentences.
std::string name_in(const Source& source, std::string_view name);

/// Gives the bytes of one of its files, part by part, to `take`, as https::fetch does.
Result<https::Response> fetch(const Source& source, std::string_view name, std::uint64_t most,
                              const std::string& etag,
                              const std::function<bool(std::span<const std::byte>)>& take);

/// The whole of a small file.
struct Text {
  https::Response response;
  std::string bytes{};
};
Result<Text> fetch_text(const Source& source, std::string_view name, std::uint64_t most,
                        const std::string& etag = {});

}  // namespace docent::update
