#include "platform/https/session.h"

#include <openssl/ssl.h>

#include <memory>
#include <span>
#include <string_view>
#include <system_error>

#include "platform/file/read_file.h"
#include "platform/file/write_file.h"

namespace docent::https {
namespace {

/// A session holds the server's certificate, of a kilobyte or two.
constexpr std::size_t largest_session = 32768;

struct FreeSession {
  void operator()(SSL_SESSION* session) const noexcept { SSL_SESSION_free(session); }
};

int place_in_context() {
  static const int index = SSL_CTX_get_ex_new_index(0, nullptr, nullptr, nullptr, nullptr);
  return index;
}

Session& session_of(const SSL* connection) {
  return *static_cast<Session*>(
      SSL_CTX_get_ex_data(SSL_get_SSL_CTX(connection), place_in_context()));
}

/// Empty for a server that is called by its address.
std::string_view host_of(const SSL* connection) {
  const char* const name = SSL_get_servername(connection, TLSEXT_NAMETYPE_host_name);
  return name != nullptr ? name : std::string_view();
}

/// libcurl makes the connection, so the only moment between that and its first message is here.
void offer(const SSL* connection, int where, int /*value*/) {
  Session& session = session_of(connection);
  if ((where & SSL_CB_HANDSHAKE_START) == 0 || session.host.empty() ||
      session.host != host_of(connection))
    return;
  const auto* at = reinterpret_cast<const unsigned char*>(session.told.data());
  const std::unique_ptr<SSL_SESSION, FreeSession> read(
      d2i_SSL_SESSION(nullptr, &at, static_cast<long>(session.told.size())));
  auto* const mine = const_cast<SSL*>(connection);  // so the callback's type has it
  if (!read || SSL_set_session(mine, read.get()) == 0) return;
  session.is_offered = true;
  if (SSL_SESSION_get_protocol_version(read.get()) != TLS1_3_VERSION) return;
  // Whoever gave it speaks TLS 1.3. What is left out is for other servers, and for machines between
  // that take it for TLS 1.2 (RFC 8446, appendix D.4): with those, it is tried without a session.
  SSL_set_min_proto_version(mine, TLS1_3_VERSION);
  SSL_set_options(mine, SSL_OP_NO_TICKET);
  SSL_clear_options(mine, SSL_OP_ENABLE_MIDDLEBOX_COMPAT);
}

int take(SSL* connection, SSL_SESSION* given) {
  Session& session = session_of(connection);
  const int size = i2d_SSL_SESSION(given, nullptr);
  if (size <= 0 || SSL_SESSION_is_resumable(given) == 0) return 0;
  session.host = host_of(connection);
  session.told.resize(static_cast<std::size_t>(size));
  auto* at = reinterpret_cast<unsigned char*>(session.told.data());
  i2d_SSL_SESSION(given, &at);
  return 0;  // OpenSSL's own stays OpenSSL's
}

}  // namespace

Session read_session(const std::filesystem::path& file) {
  if (!file::is_there(file)) return {};
  const Result<std::string> text = file::read_file(file, largest_session);
  const std::size_t end = text ? text->find('\n') : std::string::npos;
  if (end == std::string::npos) return {};
  const auto told = std::as_bytes(std::span(*text)).subspan(end + 1);
  return {.host = text->substr(0, end), .told = {told.begin(), told.end()}};
}

void keep_session(const Session& session, const std::filesystem::path& file) {
  if (session.host.empty()) {
    std::error_code gone;
    std::filesystem::remove(file, gone);
    return;
  }
  const std::string host = session.host + '\n';
  const auto name = std::as_bytes(std::span(host));
  std::vector<std::byte> bytes(name.begin(), name.end());
  bytes.insert(bytes.end(), session.told.begin(), session.told.end());
  [[maybe_unused]] const Result<void> kept = file::replace_file(file, bytes, 0600);
}

void carry(Session& session, SSL_CTX* context) {
  SSL_CTX_clear_options(context, SSL_OP_NO_TICKET);  // which libcurl sets
  SSL_CTX_set_ex_data(context, place_in_context(), &session);
  SSL_CTX_set_session_cache_mode(context, SSL_SESS_CACHE_CLIENT | SSL_SESS_CACHE_NO_INTERNAL);
  SSL_CTX_sess_set_new_cb(context, take);
  SSL_CTX_set_info_callback(context, offer);
}

}  // namespace docent::https
