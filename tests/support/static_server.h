#pragma once

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <string>
#include <thread>

#include "tests/support/run_program.h"

namespace docent::test {

/// A static web server on the loopback, as any museum has one: files of a folder, with an ETag, one
/// after another. Counts what goes over the wire above TCP.
class StaticServer {
 public:
  explicit StaticServer(std::filesystem::path folder)
      : folder_(std::move(folder)), socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket_, any, size) != 0 || ::listen(socket_, 64) != 0 ||
        ::getsockname(socket_, any, &size) != 0)
      throw std::runtime_error("no server on the loopback");
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  StaticServer(const StaticServer&) = delete;
  StaticServer& operator=(const StaticServer&) = delete;
  ~StaticServer() {
    ::shutdown(socket_, SHUT_RDWR);
    thread_.join();
    ::close(socket_);
  }

  std::string url() const { return fmt::format("http://127.0.0.1:{}", port_); }
  unsigned port() const { return port_; }
  std::size_t bytes() const { return bytes_; }
  std::size_t requests() const { return requests_; }

  /// Away: connections are taken and dropped. Half: an answer ends in the middle. Redirecting: to
  /// a file of whoever asks. Moved: everything is at another address of this server.
  enum class Mood : std::uint8_t { Well, Away, Half, Redirecting, Moved };
  void set_mood(Mood mood) { mood_ = mood; }

 private:
  void serve() {
    for (;;) {
      const int client = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
      if (client < 0) return;
      if (mood_ != Mood::Away) answer(client);
      ::close(client);
    }
  }

  void answer(int client) {
    std::string request;
    std::array<char, 4096> part{};
    while (request.find("\r\n\r\n") == std::string::npos) {
      const ssize_t size = ::recv(client, part.data(), part.size(), 0);
      if (size <= 0) return;
      request.append(part.data(), static_cast<std::size_t>(size));
    }
    ++requests_;
    std::string reply = reply_to(request);
    if (mood_ == Mood::Half) reply.resize(reply.size() / 2);
    bytes_ += request.size() + reply.size();
    for (std::size_t sent = 0; sent < reply.size();) {
      const ssize_t size = ::send(client, reply.data() + sent, reply.size() - sent, MSG_NOSIGNAL);
      if (size <= 0) return;
      sent += static_cast<std::size_t>(size);
    }
  }

  /// What is asked for, of this server or, as one asks a proxy, of any.
  static std::string name_in(const std::string& request) {
    std::size_t begin = request.find(' ') + 1;
    const std::size_t end = request.find(' ', begin);
    if (request[begin] != '/') begin = request.find('/', request.find("//", begin) + 2);
    return request.substr(begin + 1, end - begin - 1);
  }

  std::string reply_to(const std::string& request) const {
    if (mood_ == Mood::Redirecting)
      return "HTTP/1.1 302 Found\r\nLocation: file:///etc/hostname\r\nContent-Length: 0\r\n\r\n";
    const std::string name = name_in(request);
    if (mood_ == Mood::Moved && !name.starts_with(moved))
      return fmt::format("HTTP/1.1 302 Found\r\nLocation: {}/{}{}\r\nContent-Length: 0\r\n\r\n",
                         url(), moved, name);
    const auto file = folder_ / (name.starts_with(moved) ? name.substr(moved.size()) : name);
    if (!std::filesystem::exists(file))
      return "HTTP/1.1 404 Not Found\r\nContent-Length: 4\r\nConnection: close\r\n\r\nnone";
    const std::string body = text_of(file);
    const std::string tag = fmt::format("\"{:x}\"", std::hash<std::string>()(body));
    if (request.find("If-None-Match: " + tag) != std::string::npos)
      return fmt::format(
          "HTTP/1.1 304 Not Modified\r\nDate: Mon, 23 Nov 2026 15:00:00 GMT\r\nServer: nginx\r\n"
          "ETag: {}\r\nConnection: close\r\n\r\n",
          tag);
    if (const std::size_t ranges = request.find("\r\nRange: bytes="); ranges != std::string::npos)
      return parts_of(body,
                      request.substr(ranges + 15, request.find("\r\n", ranges + 2) - ranges - 15));
    return fmt::format(
        "HTTP/1.1 200 OK\r\nETag: {}\r\nContent-Length: {}\r\nConnection: close\r\n\r\n{}", tag,
        body.size(), body);
  }

  /// RFC 9110, section 14: "0-99" or "0-99,200-299".
  static std::string parts_of(const std::string& body, const std::string& ranges) {
    std::vector<std::pair<std::size_t, std::size_t>> wanted;
    for (std::size_t at = 0; at < ranges.size(); at = ranges.find(',', at) + 1) {
      const std::size_t first = std::stoul(ranges.substr(at));
      const std::size_t last = std::stoul(ranges.substr(ranges.find('-', at) + 1));
      wanted.emplace_back(first, std::min(last, body.size() - 1));
      if (ranges.find(',', at) == std::string::npos) break;
    }
    const auto content_range = [&](const auto& range) {
      return fmt::format("Content-Range: bytes {}-{}/{}\r\n", range.first, range.second,
                         body.size());
    };
    std::string parts, type;
    if (wanted.size() == 1) {
      type = content_range(wanted[0]);
      parts = body.substr(wanted[0].first, wanted[0].second - wanted[0].first + 1);
    } else {
      type = "Content-Type: multipart/byteranges; boundary=part\r\n";
      for (const auto& range : wanted)
        parts += fmt::format("\r\n--part\r\nContent-Type: application/octet-stream\r\n{}\r\n{}",
                             content_range(range),
                             body.substr(range.first, range.second - range.first + 1));
      parts += "\r\n--part--\r\n";
    }
    return fmt::format(
        "HTTP/1.1 206 Partial Content\r\n{}Content-Length: {}\r\nConnection: close\r\n\r\n{}", type,
        parts.size(), parts);
  }

  static constexpr std::string_view moved = "moved/";

  std::filesystem::path folder_;
  int socket_;
  unsigned port_ = 0;
  std::atomic<Mood> mood_ = Mood::Well;
  std::atomic<std::size_t> bytes_ = 0, requests_ = 0;
  std::thread thread_;
};

}  // namespace docent::test
