#pragma once

#include <openssl/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace docent::https {

/// What a server gave so that the next connection goes on where the last one ended, and no
/// certificates are sent: a session of TLS (RFC 8446, section 2.2; RFC 5077 before it). The server
/// was verified when it gave it, and says for how long it holds.
///
/// A secret: with it one can take part in the next connection. It is kept in a file that only its
/// owner may read, and offered to no other host than the one that gave it.
struct Session {
  std::string host{};             ///< As the certificate calls it; empty: there is none.
  std::vector<std::byte> told{};  ///< ASN.1, as OpenSSL writes it.
  bool is_offered = false;        ///< To a server, since it was read.
};

/// The session of a file; none where it cannot be read or is none.
Session read_session(const std::filesystem::path& file);
/// Keeps a session, or removes the file where there is none. Where that fails, the next connection
/// takes more bytes.
void keep_session(const Session& session, const std::filesystem::path& file);

/// Has the connections that are made of `context` offer the session and put in its place what the
/// server gives. It has to live as long as they do.
void carry(Session& session, SSL_CTX* context);

}  // namespace docent::https
