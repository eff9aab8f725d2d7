#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "runtime/model/result.h"

namespace docent::https {

struct Request {
  std::string url{};       ///< http or https.
  std::string etag{};      ///< Of what is known already; may be empty.
  std::uint64_t most = 0;  ///< Bytes; a larger answer is an error.
};

struct Response {
  enum class Kind : std::uint8_t { Fetched, NotModified, NotFound } kind = Kind::Fetched;
  std::string etag{};
};

/// Fetches a file and gives its bytes, part by part, to `take`, which returns false to end it.
/// Follows no redirection to another protocol. Environment, with a sentence, where the server
/// cannot be reached, refuses, says nothing for a minute or sends more than it should. Authorities
/// are the system's, or those of the file that SSL_CERT_FILE names.
Result<Response> fetch(const Request& request,
                       const std::function<bool(std::span<const std::byte>)>& take);

}  // namespace docent::https
