#pragma once

#include <arpa/inet.h>
#include <fmt/format.h>
#include <netinet/in.h>
#include <openssl/ssl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace docent::test {

/// What a server proves its name by: "localhost", signed by an authority that a root has signed, as
/// a museum's is. Keys are "rsa:2048" or "ec -pkeyopt ec_paramgen_curve:P-256".
struct Certificates {
  Certificates(const std::filesystem::path& in, const std::string& keys) : folder(in) {
    std::filesystem::create_directories(folder);
    std::ofstream(file("authority")) << "basicConstraints=critical,CA:TRUE\n";
    std::ofstream(file("name")) << "subjectAltName=DNS:localhost\n";
    run("req -x509 -nodes -newkey " + keys + " -keyout root.key -out root.pem -subj /CN=Root");
    sign("between", "root", "authority", keys);
    sign("localhost", "between", "name", keys);
    std::ofstream(chain()) << std::ifstream(file("localhost.pem")).rdbuf()
                           << std::ifstream(file("between.pem")).rdbuf();
  }
  std::string root() const { return file("root.pem"); }
  std::string chain() const { return file("chain.pem"); }
  std::string key() const { return file("localhost.key"); }

 private:
  std::string file(const std::string& name) const { return (folder / name).string(); }
  void run(const std::string& arguments) const {
    const std::string command =
        "cd '" + folder.string() + "' && openssl " + arguments + " 2>openssl.log";
    if (std::system(command.c_str()) != 0)  // NOLINT(bugprone-command-processor)
      throw std::runtime_error("failed: " + command);
  }
  void sign(const std::string& name, const std::string& by, const std::string& as,
            const std::string& keys) const {
    run(fmt::format("req -nodes -newkey {1} -keyout {0}.key -out {0}.csr -subj /CN={0}", name,
                    keys));
    run(
        fmt::format("x509 -req -in {0}.csr -CA {1}.pem -CAkey {1}.key -CAcreateserial -out {0}.pem "
                    "-extfile {2}",
                    name, by, as));
  }

  std::filesystem::path folder;
};

/// TLS in front of a server on the loopback, as OpenSSL does it for nginx and others: one
/// connection after another, one request in each. Counts what goes over the wire above TCP.
class TlsServer {
 public:
  TlsServer(const Certificates& certificates, unsigned behind, int newest = TLS1_3_VERSION)
      : certificates_(certificates),
        newest_(newest),
        behind_(behind),
        socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    forget_sessions();
    sockaddr_in address = loopback(0);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    if (::bind(socket_, any, size) != 0 || ::listen(socket_, 64) != 0 ||
        ::getsockname(socket_, any, &size) != 0)
      throw std::runtime_error("no server on the loopback");
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  TlsServer(const TlsServer&) = delete;
  TlsServer& operator=(const TlsServer&) = delete;
  ~TlsServer() {
    ::shutdown(socket_, SHUT_RDWR);
    thread_.join();
    ::close(socket_);
  }

  std::string url() const { return fmt::format("https://localhost:{}", port_); }
  /// Of the connections that have ended; waits for the last one.
  std::size_t bytes() const {
    while (ended_ != connections_) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return bytes_;
  }
  std::size_t connections() const { return connections_; }
  std::size_t resumed() const { return resumed_; }

  /// As one that was started again; between two connections.
  void forget_sessions() {
    context_.reset(SSL_CTX_new(TLS_server_method()));
    SSL_CTX_set_max_proto_version(context_.get(), newest_);
    if (SSL_CTX_use_certificate_chain_file(context_.get(), certificates_.chain().c_str()) != 1 ||
        SSL_CTX_use_PrivateKey_file(context_.get(), certificates_.key().c_str(),
                                    SSL_FILETYPE_PEM) != 1)
      throw std::runtime_error("no certificates");
    SSL_CTX_set_client_hello_cb(context_.get(), look_at_hello, this);
  }
  /// Hangs up on whoever offers a session, as a machine between that does not know TLS 1.3.
  void refuse_sessions() { refuses_ = true; }

 private:
  struct Free {
    void operator()(SSL_CTX* context) const noexcept { SSL_CTX_free(context); }
    void operator()(SSL* connection) const noexcept { SSL_free(connection); }
  };

  static sockaddr_in loopback(unsigned port) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    address.sin_port = htons(static_cast<std::uint16_t>(port));
    return address;
  }

  static int look_at_hello(SSL* connection, int* /*alert*/, void* user) {
    const unsigned char* offered = nullptr;
    std::size_t size = 0;
    const bool offers =
        SSL_client_hello_get0_ext(connection, TLSEXT_TYPE_psk, &offered, &size) == 1;
    return offers && static_cast<TlsServer*>(user)->refuses_ ? SSL_CLIENT_HELLO_ERROR
                                                             : SSL_CLIENT_HELLO_SUCCESS;
  }

  void serve() {
    for (;;) {
      const int client = ::accept4(socket_, nullptr, nullptr, SOCK_CLOEXEC);
      if (client < 0) return;
      ++connections_;
      const std::unique_ptr<SSL, Free> connection(SSL_new(context_.get()));
      SSL_set_fd(connection.get(), client);
      if (SSL_accept(connection.get()) == 1) answer(connection.get());
      ::close(client);
      ++ended_;
    }
  }

  void answer(SSL* connection) {
    resumed_ += SSL_session_reused(connection) == 1 ? 1 : 0;
    std::string request;
    std::array<char, 4096> part{};
    while (request.find("\r\n\r\n") == std::string::npos) {
      const int size = SSL_read(connection, part.data(), static_cast<int>(part.size()));
      if (size <= 0) return;
      request.append(part.data(), static_cast<std::size_t>(size));
    }
    const std::string reply = reply_from_behind(request);
    SSL_write(connection, reply.data(), static_cast<int>(reply.size()));
    const BIO* const wire = SSL_get_rbio(connection);
    bytes_ += BIO_number_read(const_cast<BIO*>(wire)) + BIO_number_written(const_cast<BIO*>(wire));
  }

  std::string reply_from_behind(const std::string& request) const {
    const int server = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    const sockaddr_in address = loopback(behind_);
    std::string reply;
    std::array<char, 4096> part{};
    if (::connect(server, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0 &&
        ::send(server, request.data(), request.size(), MSG_NOSIGNAL) > 0)
      for (ssize_t size = 0; (size = ::recv(server, part.data(), part.size(), 0)) > 0;)
        reply.append(part.data(), static_cast<std::size_t>(size));
    ::close(server);
    return reply;
  }

  Certificates certificates_;
  int newest_;
  unsigned behind_;
  int socket_;
  unsigned port_ = 0;
  std::unique_ptr<SSL_CTX, Free> context_;
  std::atomic<bool> refuses_ = false;
  std::atomic<std::size_t> bytes_ = 0, connections_ = 0, ended_ = 0, resumed_ = 0;
  std::thread thread_;
};

}  // namespace docent::test
