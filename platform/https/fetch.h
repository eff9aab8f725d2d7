#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>
#include <string>

#include "runtime/model/result.h"

namespace docent::https {

struct Request {
  std::string url{};                ///< http or https.
  std::string etag{};               ///< Of what is known already; may be empty.
  std::uint64_t most = 0;           ///< Bytes; a larger answer is an error.
  std::filesystem::path session{};  ///< Where a session of TLS is kept (session.h); may be empty.
};

struct Response {
  enum class Kind : std::uint8_t { Fetched, NotModified, NotFound } kind = Kind::Fetched;
  std::string etag{};
};

/// Fetches a file and gives its bytes, part by part, to `take`, which returns false to end it.
/// Follows five redirections, from https to https alone. Environment, with a sentence, where the
/// server cannot be reached, refuses, says nothing for a minute or sends more than it should.
/// Authorities are the system's, or those of the file that SSL_CERT_FILE names. Where a session is
/// kept, the server's certificates are asked for only when the server no longer knows it.
Result<Response> fetch(const Request& request,
                       const std::function<bool(std::span<const std::byte>)>& take);

}  // namespace docent::https
