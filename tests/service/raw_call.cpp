#include "tests/service/raw_call.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <zlib.h>

#include <algorithm>
#include <stdexcept>

#include "server/transport/descriptor.h"
#include "tests/service/timing.h"

namespace remeshd::test {
namespace {

enum Frame : unsigned char { kData = 0, kHeaders = 1, kReset = 3, kSettings = 4, kGoAway = 7 };
constexpr unsigned char kEndStream = 1, kEndHeaders = 4;
constexpr std::size_t kMostInFrame = 16384, kHeaderBytes = 9;

std::string frame(Frame type, unsigned char flags, unsigned stream, const std::string& payload) {
  std::string bytes;
  for (const unsigned shift : {16U, 8U, 0U})
    bytes += static_cast<char>(payload.size() >> shift & 255U);
  bytes += static_cast<char>(type);
  bytes += static_cast<char>(flags);
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    bytes += static_cast<char>(stream >> shift & 255U);
  return bytes + payload;
}

/// A header in HPACK's plainest form: a literal that is not indexed. Texts below 127 bytes.
std::string header(const std::string& name, const std::string& value) {
  std::string bytes(1, '\0');
  bytes += static_cast<char>(name.size());
  bytes += name;
  bytes += static_cast<char>(value.size());
  return bytes + value;
}

Descriptor connected(const std::string& address) {
  const auto colon = address.rfind(':');
  Descriptor socket(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(colon + 1))));
  ::inet_pton(AF_INET, address.substr(0, colon).c_str(), &to.sin_addr);
  const timeval limit{.tv_sec = 10, .tv_usec = 0};
  ::setsockopt(socket.get(), SOL_SOCKET, SO_RCVTIMEO, &limit, sizeof limit);
  if (::connect(socket.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to) != 0)
    throw std::runtime_error("no connection to " + address);
  return socket;
}

void send_all(int socket, std::string_view bytes) {
  while (!bytes.empty()) {
    const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
    if (sent <= 0) return;  // the answer tells why
    bytes.remove_prefix(static_cast<std::size_t>(sent));
  }
}

std::string receive(int socket, std::size_t bytes) {
  std::string text(bytes, '\0');
  for (std::size_t have = 0; have < bytes;) {
    const ssize_t got = ::recv(socket, text.data() + have, bytes - have, 0);
    if (got <= 0) throw std::runtime_error("no answer to a raw call");
    have += static_cast<std::size_t>(got);
  }
  return text;
}

/// Reads frames until one ends the stream.
void await_end(int socket) {
  for (;;) {
    const std::string head = receive(socket, kHeaderBytes);
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(head[i]); };
    receive(socket, std::size_t{byte(0)} << 16U | std::size_t{byte(1)} << 8U | byte(2));
    const bool ends = byte(3) == kHeaders && (byte(4) & kEndStream) != 0;
    if (ends || byte(3) == kReset || byte(3) == kGoAway) return;
  }
}

}  // namespace

double raw_call(const std::string& address, const std::string& method, const std::string& message) {
  const Descriptor socket = connected(address);
  std::string body(1, '\1');  // compressed
  for (const unsigned shift : {24U, 16U, 8U, 0U})
    body += static_cast<char>(message.size() >> shift & 255U);
  body += message;
  std::string bytes = "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n" + frame(kSettings, 0, 0, "");
  bytes +=
      frame(kHeaders, kEndHeaders, 1,
            header(":method", "POST") + header(":scheme", "http") + header(":path", method) +
                header(":authority", "localhost") + header("content-type", "application/grpc") +
                header("te", "trailers") + header("grpc-encoding", "gzip"));
  for (std::size_t from = 0; from < body.size(); from += kMostInFrame) {
    const bool last = from + kMostInFrame >= body.size();
    bytes += frame(kData, last ? kEndStream : 0, 1, body.substr(from, kMostInFrame));
  }
  const auto start = Clock::now();
  send_all(socket.get(), bytes);
  await_end(socket.get());
  return seconds_since(start);
}

std::string gzip_bomb(std::size_t bytes) {
  std::string plain(bytes, ' ');
  std::string packed(1024 + bytes / 500, '\0');
  z_stream stream{};
  constexpr int kGzip = 15 + 16;
  deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kGzip, 9, Z_DEFAULT_STRATEGY);
  stream.next_in = reinterpret_cast<Bytef*>(plain.data());
  stream.avail_in = static_cast<uInt>(plain.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(packed.size() - stream.avail_out);
  deflateEnd(&stream);
  return packed;
}

}  // namespace remeshd::test
