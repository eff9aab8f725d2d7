#include "platform/https/fetch.h"

#include <curl/curl.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <memory>
#include <string_view>

#include "platform/https/connection.h"
#include "platform/https/session.h"

namespace docent::https {
namespace {

struct CloseCurl {
  void operator()(CURL* curl) const noexcept { curl_easy_cleanup(curl); }
  void operator()(curl_slist* list) const noexcept { curl_slist_free_all(list); }
};

constexpr long connect_seconds = 30, silent_seconds = 60, most_redirections = 5;
constexpr long status_not_modified = 304, status_not_found = 404, first_bad_status = 400;

/// One transfer as it goes on.
struct Transfer {
  CURL* curl = nullptr;
  const std::function<bool(std::span<const std::byte>)>* take = nullptr;
  std::uint64_t left = 0;
  bool is_too_large = false;
  std::string etag;
};

long status_of(CURL* curl) {
  long status = 0;
  curl_easy_getinfo(curl, CURLINFO_RESPONSE_CODE, &status);
  return status;
}

std::size_t take_body(char* data, std::size_t /*one*/, std::size_t size, void* user) {
  Transfer& transfer = *static_cast<Transfer*>(user);
  if (status_of(transfer.curl) >= first_bad_status) return size;  // a page that says so to people
  transfer.is_too_large = size > transfer.left;
  if (transfer.is_too_large) return 0;
  transfer.left -= size;
  return (*transfer.take)(std::as_bytes(std::span(data, size))) ? size : 0;
}

std::size_t take_header(char* data, std::size_t /*one*/, std::size_t size, void* user) {
  constexpr std::string_view name = "etag:";
  std::string_view line(data, size);
  const auto is_same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) == b;
  };
  if (line.size() < name.size() || !std::equal(name.begin(), name.end(), line.begin(),
                                               [&](char b, char a) { return is_same(a, b); }))
    return size;
  line.remove_prefix(name.size());
  while (!line.empty() && line.front() == ' ') line.remove_prefix(1);
  while (!line.empty() && (line.back() == '\n' || line.back() == '\r' || line.back() == ' '))
    line.remove_suffix(1);
  // One word, as the state that keeps it is written in words.
  if (line.find(' ') == std::string_view::npos) static_cast<Transfer*>(user)->etag = line;
  return size;
}

std::unexpected<Error> failure(const Request& request, std::string_view why) {
  return std::unexpected(
      Error{Errc::Environment, fmt::format("{}: cannot be fetched: {}; what is shown stays, and it "
                                           "is tried again",
                                           request.url, why)});
}

/// What is asked for, besides how.
void prepare(CURL* curl, const Request& request, const curl_slist* headers, Transfer& transfer) {
  curl_easy_setopt(curl, CURLOPT_URL, request.url.c_str());
  curl_easy_setopt(curl, CURLOPT_PROTOCOLS_STR, "http,https");
  curl_easy_setopt(curl, CURLOPT_REDIR_PROTOCOLS_STR,
                   request.url.starts_with("https:") ? "https" : "http,https");
  curl_easy_setopt(curl, CURLOPT_FOLLOWLOCATION, 1L);
  curl_easy_setopt(curl, CURLOPT_MAXREDIRS, most_redirections);
  curl_easy_setopt(curl, CURLOPT_CONNECTTIMEOUT, connect_seconds);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_LIMIT, 1L);
  curl_easy_setopt(curl, CURLOPT_LOW_SPEED_TIME, silent_seconds);
  curl_easy_setopt(curl, CURLOPT_NOSIGNAL, 1L);
  curl_easy_setopt(curl, CURLOPT_USERAGENT, "docent-update");
  curl_easy_setopt(curl, CURLOPT_WRITEFUNCTION, take_body);
  curl_easy_setopt(curl, CURLOPT_WRITEDATA, &transfer);
  curl_easy_setopt(curl, CURLOPT_HEADERFUNCTION, take_header);
  curl_easy_setopt(curl, CURLOPT_HEADERDATA, &transfer);
  curl_easy_setopt(curl, CURLOPT_HTTPHEADER, headers);
  if (const char* authorities = std::getenv("SSL_CERT_FILE"))  // which libcurl's own file hides
    curl_easy_setopt(curl, CURLOPT_CAINFO, authorities);
}

/// Fetches with the session that is kept. Where the server does not answer to it, it is tried again
/// as if there were none: a session never costs more than that.
CURLcode perform(CURL* curl, const Request& request) {
  Session session = read_session(request.session);
  prepare_connection(curl, session);
  CURLcode done = curl_easy_perform(curl);
  if (done != CURLE_OK && session.is_offered && status_of(curl) == 0) {
    session = {};
    done = curl_easy_perform(curl);
  }
  if (!request.session.empty())
    keep_session(done == CURLE_OK ? session : Session{}, request.session);
  return done;
}

}  // namespace

Result<Response> fetch(const Request& request,
                       const std::function<bool(std::span<const std::byte>)>& take) {
  static const CURLcode started = curl_global_init(CURL_GLOBAL_DEFAULT);
  const std::unique_ptr<CURL, CloseCurl> curl(started == CURLE_OK ? curl_easy_init() : nullptr);
  if (!curl) return failure(request, "libcurl does not start");
  Transfer transfer{.curl = curl.get(), .take = &take, .left = request.most, .etag = {}};
  const std::unique_ptr<curl_slist, CloseCurl> headers(curl_slist_append(nullptr, "Accept:"));
  if (!request.etag.empty())
    curl_slist_append(headers.get(), fmt::format("If-None-Match: {}", request.etag).c_str());
  prepare(curl.get(), request, headers.get(), transfer);
  const CURLcode done = perform(curl.get(), request);
  if (transfer.is_too_large)
    return failure(request, fmt::format("it has more than {} bytes", request.most));
  if (done != CURLE_OK) return failure(request, curl_easy_strerror(done));
  const long status = status_of(curl.get());
  if (status == status_not_found) return Response{.kind = Response::Kind::NotFound};
  if (status == status_not_modified)
    return Response{.kind = Response::Kind::NotModified, .etag = request.etag};
  if (status >= first_bad_status)
    return failure(request, fmt::format("the server answers {}", status));
  return Response{.kind = Response::Kind::Fetched, .etag = std::move(transfer.etag)};
}

}  // namespace docent::https
