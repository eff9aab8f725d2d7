#include "platform/https/connection.h"

#include <netinet/in.h>
#include <netinet/tcp.h>
#include <openssl/ssl.h>
#include <sys/socket.h>

namespace docent::https {
namespace {

/// What every server of today speaks, and of its names as few as that takes.
constexpr const char* suites =
    "TLS_AES_128_GCM_SHA256:TLS_AES_256_GCM_SHA384:TLS_CHACHA20_POLY1305_SHA256";
constexpr const char* suites_of_tls_1_2 = "ECDHE+AESGCM:ECDHE+CHACHA20";
constexpr const char* groups = "X25519:P-256:P-384";
constexpr const char* signatures =
    "ECDSA+SHA256:RSA-PSS+SHA256:RSA+SHA256:ECDSA+SHA384:RSA-PSS+SHA384:RSA+SHA384:"
    "RSA-PSS+SHA512:RSA+SHA512:ed25519";

CURLcode prepare_tls(CURL* /*curl*/, void* made, void* session) {
  auto* const context = static_cast<SSL_CTX*>(made);
  SSL_CTX_set_ciphersuites(context, suites);
  SSL_CTX_set_cipher_list(context, suites_of_tls_1_2);
  SSL_CTX_set1_groups_list(context, groups);
  SSL_CTX_set1_sigalgs_list(context, signatures);
  SSL_CTX_set_options(context, SSL_OP_NO_ENCRYPT_THEN_MAC);  // of suites that are not asked for
  SSL_CTX_clear_options(context, SSL_OP_TLSEXT_PADDING);     // for servers of 2014
  SSL_CTX_set_post_handshake_auth(context, 0);
  SSL_CTX_set_quiet_shutdown(context, 1);  // where an answer ends, HTTP says
  carry(*static_cast<Session*>(session), context);
  return CURLE_OK;
}

/// Acknowledgements may wait for what is sent anyway (tcp(7)).
int prepare_socket(void* /*user*/, curl_socket_t socket, curlsocktype /*purpose*/) {
  const int no = 0;
  ::setsockopt(socket, IPPROTO_TCP, TCP_QUICKACK, &no, sizeof no);
  return CURL_SOCKOPT_OK;
}

}  // namespace

void prepare_connection(CURL* curl, Session& session) {
  curl_easy_setopt(curl, CURLOPT_SSL_CTX_FUNCTION, prepare_tls);
  curl_easy_setopt(curl, CURLOPT_SSL_CTX_DATA, &session);
  curl_easy_setopt(curl, CURLOPT_SOCKOPTFUNCTION, prepare_socket);
  curl_easy_setopt(curl, CURLOPT_TCP_NODELAY, 0L);
  // HTTP/2 begins with settings, which for one request are more than the request.
  curl_easy_setopt(curl, CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
  curl_easy_setopt(curl, CURLOPT_SSL_ENABLE_ALPN, 0L);
}

}  // namespace docent::https
