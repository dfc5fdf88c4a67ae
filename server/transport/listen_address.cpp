#include "server/transport/listen_address.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/un.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/base/error.h"

namespace remeshd {
namespace {

constexpr std::string_view kUnix = "unix:";

Error invalid(const std::string& text, std::string_view why) {
  ErrorInfo info;
  info.kind = ErrorKind::InvalidArgument;
  info.reason = "LISTEN_INVALID";
  info.message = "cannot listen on `" + text + "`: ";
  info.message += why;
  info.stage = "request";
  info.parameter = "listen";
  info.hint =
      "give HOST:PORT, as 127.0.0.1:50051, [::1]:50051 or localhost:50051, or unix:/PATH for a "
      "Unix socket";
  return Error(std::move(info));
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::optional<std::uint16_t> parse_port(std::string_view text) {
  if (text.empty() || text.size() > 5 || !std::all_of(text.begin(), text.end(), is_digit))
    return std::nullopt;
  unsigned port = 0;
  std::from_chars(text.data(), text.data() + text.size(), port);
  if (port > 65535) return std::nullopt;
  return static_cast<std::uint16_t>(port);
}

std::optional<SocketAddress> ipv4(const std::string& host, std::uint16_t port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  if (::inet_pton(AF_INET, host.c_str(), &address.sin_addr) != 1) return std::nullopt;
  SocketAddress out{.size = sizeof(address)};
  std::memcpy(&out.storage, &address, sizeof(address));
  return out;
}

std::optional<SocketAddress> ipv6(const std::string& host, std::uint16_t port) {
  sockaddr_in6 address{};
  address.sin6_family = AF_INET6;
  address.sin6_port = htons(port);
  if (::inet_pton(AF_INET6, host.c_str(), &address.sin6_addr) != 1) return std::nullopt;
  SocketAddress out{.size = sizeof(address)};
  std::memcpy(&out.storage, &address, sizeof(address));
  return out;
}

/// Letters, digits, `-`, `_` in labels with dots between. A last label of digits would make the
/// resolver take the name for a number: `0` and `127.1` are addresses to it.
bool is_host_name(std::string_view host) {
  const auto fits = [](char c) {
    return is_digit(c) || is_letter(c) || c == '-' || c == '.' || c == '_';
  };
  if (host.empty() || host.size() > 253 || !std::all_of(host.begin(), host.end(), fits))
    return false;
  if (host.front() == '.' || host.front() == '-' || host.find("..") != std::string_view::npos)
    return false;
  if (host.back() == '.') host.remove_suffix(1);
  const std::string_view last = host.substr(host.rfind('.') + 1);
  return !last.empty() && is_letter(last.front());
}

std::vector<SocketAddress> resolve(const std::string& host, std::uint16_t port) {
  if (host == "localhost") return {*ipv4("127.0.0.1", port), *ipv6("::1", port)};
  addrinfo wanted{};
  wanted.ai_socktype = SOCK_STREAM;
  wanted.ai_flags = AI_NUMERICSERV;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &wanted, &found) != 0) return {};
  const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> hold(found, &::freeaddrinfo);
  std::vector<SocketAddress> out;
  for (const addrinfo* entry = found; entry != nullptr; entry = entry->ai_next) {
    if (entry->ai_family != AF_INET && entry->ai_family != AF_INET6) continue;
    SocketAddress address{.size = entry->ai_addrlen};
    std::memcpy(&address.storage, entry->ai_addr, entry->ai_addrlen);
    out.push_back(address);
  }
  return out;
}

ListenAddress parse_unix(const std::string& text) {
  const std::string given = text.substr(kUnix.size());
  if (given.find('\0') != std::string::npos || given.empty() || given.front() != '/' ||
      given.back() == '/')
    throw invalid(text, "the path of a Unix socket is that of a file, and absolute");
  ListenAddress out;
  out.path = std::filesystem::path(given).lexically_normal();
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (out.path.size() >= sizeof(address.sun_path))
    throw invalid(text, "the path of a Unix socket has at most " +
                            std::to_string(sizeof(address.sun_path) - 1) + " bytes");
  std::memcpy(address.sun_path, out.path.c_str(), out.path.size() + 1);
  SocketAddress socket{.size = sizeof(address)};
  std::memcpy(&socket.storage, &address, sizeof(address));
  out.sockets.push_back(socket);
  return out;
}

bool is_loopback(const SocketAddress& address) {
  if (address.storage.ss_family == AF_UNIX) return true;
  if (address.storage.ss_family == AF_INET) {
    sockaddr_in in{};
    std::memcpy(&in, &address.storage, sizeof(in));
    return ntohl(in.sin_addr.s_addr) >> 24U == 127;
  }
  sockaddr_in6 in{};
  std::memcpy(&in, &address.storage, sizeof(in));
  return IN6_IS_ADDR_LOOPBACK(&in.sin6_addr) != 0;
}

}  // namespace

bool ListenAddress::is_loopback() const {
  return std::all_of(sockets.begin(), sockets.end(),
                     [](const SocketAddress& socket) { return remeshd::is_loopback(socket); });
}

std::string numeric(const SocketAddress& address) {
  char text[INET6_ADDRSTRLEN] = "";
  if (address.storage.ss_family == AF_INET) {
    sockaddr_in in{};
    std::memcpy(&in, &address.storage, sizeof(in));
    ::inet_ntop(AF_INET, &in.sin_addr, text, sizeof(text));
    return std::string(text) + ':' + std::to_string(ntohs(in.sin_port));
  }
  if (address.storage.ss_family != AF_INET6) return "";
  sockaddr_in6 in{};
  std::memcpy(&in, &address.storage, sizeof(in));
  ::inet_ntop(AF_INET6, &in.sin6_addr, text, sizeof(text));
  return '[' + std::string(text) + "]:" + std::to_string(ntohs(in.sin6_port));
}

ListenAddress parse_listen_address(const std::string& text) {
  if (text.starts_with(kUnix)) return parse_unix(text);
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) throw invalid(text, "the port is missing");
  const auto port = parse_port(std::string_view(text).substr(colon + 1));
  if (!port) throw invalid(text, "the port is not a number from 0 to 65535");
  ListenAddress out;
  out.port = *port;
  out.host = text.substr(0, colon);
  if (out.host.starts_with('[') && out.host.ends_with(']')) {
    const auto address = ipv6(out.host.substr(1, out.host.size() - 2), *port);
    if (!address) throw invalid(text, "what stands in brackets is no IPv6 address");
    out.sockets.push_back(*address);
  } else if (const auto address = ipv4(out.host, *port)) {
    out.sockets.push_back(*address);
  } else if (out.host.empty()) {
    throw invalid(text, "the host is missing");
  } else if (out.host.find(':') != std::string::npos) {
    throw invalid(text, "an IPv6 address stands in brackets");
  } else if (!is_host_name(out.host)) {
    throw invalid(text, "the host is neither an address nor a name");
  } else {
    out.sockets = resolve(out.host, *port);
    if (out.sockets.empty()) throw invalid(text, "no address is known of this host");
  }
  return out;
}

}  // namespace remeshd
