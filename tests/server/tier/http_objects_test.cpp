#include "server/tier/http_objects.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <openssl/evp.h>
#include <openssl/hmac.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <sstream>
#include <stop_token>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "proto/checksum.h"
#include "server/tier/tier_error.h"
#include "tests/support/expect_error.h"

namespace remeshd::test {
namespace {

struct Request {
  std::string method, path, body;
  std::map<std::string, std::string> headers;  ///< by name in lower case
};

/// Has the socket listen; returns the port.
int listen_on_loopback(int listener) {
  sockaddr_in address{.sin_family = AF_INET, .sin_addr = {::htonl(INADDR_LOOPBACK)}};
  socklen_t size = sizeof address;
  auto* const general = reinterpret_cast<sockaddr*>(&address);
  EXPECT_EQ(::bind(listener, general, size), 0);
  EXPECT_EQ(::listen(listener, 8), 0);
  EXPECT_EQ(::getsockname(listener, general, &size), 0);
  return ::ntohs(address.sin_port);
}

/// Answers each request, one a connection, with the same status and body; keeps what was asked.
class HttpServer {
 public:
  explicit HttpServer(int status = 200, std::string body = "")
      : status_(status), body_(std::move(body)), listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    url_ = "http://127.0.0.1:" + std::to_string(listen_on_loopback(listener_)) + "/bucket";
    thread_ = std::thread([this] { serve(); });
  }
  ~HttpServer() { stop(); }
  HttpServer(const HttpServer&) = delete;
  HttpServer& operator=(const HttpServer&) = delete;

  [[nodiscard]] HttpAccess plain() const { return {.url = url_}; }
  [[nodiscard]] HttpAccess s3() const {
    return {
        .url = url_, .region = "us-east-1", .access_key = "farm:daemon", .secret_key = "secret"};
  }
  /// The only one; ends the server.
  Request request() {
    stop();
    EXPECT_EQ(requests_.size(), 1U);
    return requests_.empty() ? Request{} : requests_.front();
  }

 private:
  void stop() {
    if (!thread_.joinable()) return;
    ::shutdown(listener_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
  }
  void serve() {
    for (int peer = 0; (peer = ::accept(listener_, nullptr, nullptr)) >= 0; ::close(peer))
      answer(peer);
  }
  void answer(int peer) {
    std::string text;
    const auto read_on = [&] {
      std::array<char, 4096> piece{};
      const ssize_t count = ::recv(peer, piece.data(), piece.size(), 0);
      if (count > 0) text.append(piece.data(), static_cast<std::size_t>(count));
      return count > 0;
    };
    while (text.find("\r\n\r\n") == std::string::npos)
      if (!read_on()) return;
    const std::size_t head = text.find("\r\n\r\n");
    std::istringstream lines(text.substr(0, head));
    Request request;
    lines >> request.method >> request.path;
    std::string line;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      if (line.ends_with('\r')) line.pop_back();
      std::string name = line.substr(0, line.find(':'));
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
      request.headers[name] = line.substr(std::min(line.size(), line.find(':') + 2));
    }
    const auto length = request.headers.find("content-length");
    const std::size_t size = length == request.headers.end() ? 0 : std::stoul(length->second);
    while (text.size() < head + 4 + size)
      if (!read_on()) return;
    request.body = text.substr(head + 4);
    const std::string answer =
        "HTTP/1.1 " + std::to_string(status_) +
        " Told\r\nConnection: close\r\nContent-Length: " + std::to_string(body_.size()) +
        "\r\n\r\n" + (request.method == "HEAD" ? "" : body_);
    requests_.push_back(std::move(request));
    ::send(peer, answer.data(), answer.size(), MSG_NOSIGNAL);
  }

  const int status_;
  const std::string body_;
  const int listener_;
  std::string url_;
  std::vector<Request> requests_;
  std::thread thread_;
};

std::string hmac(std::string_view key, std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> mac{};
  unsigned size = 0;
  HMAC(EVP_sha256(), key.data(), static_cast<int>(key.size()),
       reinterpret_cast<const unsigned char*>(text.data()), text.size(), mac.data(), &size);
  return {reinterpret_cast<const char*>(mac.data()), size};
}

/// The text between two others.
std::string between(const std::string& text, const std::string& begin, const std::string& end) {
  const std::size_t at = text.find(begin);
  if (at == std::string::npos) return "";
  return text.substr(at + begin.size(), text.find(end, at + begin.size()) - at - begin.size());
}

/// Checks that it is signed as S3 checks it (AWS signature, version 4): of the headers as they
/// came.
void expect_signed(Request request) {
  const std::string authorization = request.headers["authorization"];
  const std::string names = between(authorization, "SignedHeaders=", ",");
  std::string canonical = request.method + "\n" + request.path + "\n\n", name;
  for (std::istringstream all(names); std::getline(all, name, ';');) {
    EXPECT_TRUE(request.headers.contains(name)) << name << " is signed but was not sent";
    canonical += name + ":" + request.headers[name] + "\n";
  }
  EXPECT_NE((";" + names + ";").find(";x-amz-content-sha256;"), std::string::npos) << names;
  EXPECT_EQ(request.headers["x-amz-content-sha256"], sha256_hex(request.body));
  canonical += "\n" + names + "\n" + sha256_hex(request.body);
  const std::string date = request.headers["x-amz-date"], day = date.substr(0, 8);
  const std::string scope = day + "/us-east-1/s3/aws4_request";
  EXPECT_EQ(between(authorization, "Credential=", ","), "farm:daemon/" + scope);
  const std::string key =
      hmac(hmac(hmac(hmac("AWS4secret", day), "us-east-1"), "s3"), "aws4_request");
  EXPECT_EQ(
      between(authorization, "Signature=", ","),
      to_hex(hmac(key, "AWS4-HMAC-SHA256\n" + date + "\n" + scope + "\n" + sha256_hex(canonical))));
}

TEST(HttpObjects, OfABucketOfS3ArePutWithASignatureThatHolds) {
  HttpServer server;
  const std::string bytes("a\0b\nc", 5);
  HttpObjects(server.s3()).put("recipe/ab/abc", bytes);
  const Request request = server.request();
  EXPECT_EQ(request.method, "PUT");
  EXPECT_EQ(request.path, "/bucket/recipe/ab/abc");
  EXPECT_EQ(request.body, bytes);
  expect_signed(request);
}

TEST(HttpObjects, OfSeveralMegabytesReachABucketWhole) {
  HttpServer server;
  const std::string bytes(3 << 20, 'x');
  HttpObjects(server.s3()).put("pack/ab/abc", bytes);
  const Request request = server.request();
  EXPECT_EQ(request.body, bytes);
  expect_signed(request);
}

TEST(HttpObjects, OfABucketOfS3AreGotWithASignatureThatHolds) {
  HttpServer server(200, "bytes");
  EXPECT_EQ(HttpObjects(server.s3()).get("recipe/ab/abc", {}), "bytes");
  const Request request = server.request();
  EXPECT_EQ(request.method, "GET");
  expect_signed(request);
}

TEST(HttpObjects, OfABucketOfS3AreLookedForWithASignatureThatHolds) {
  HttpServer server;
  EXPECT_TRUE(HttpObjects(server.s3()).has("recipe/ab/abc", 5));
  const Request request = server.request();
  EXPECT_EQ(request.method, "HEAD");
  expect_signed(request);
}

TEST(HttpObjects, OfAPlainServerAreNotSigned) {
  HttpServer server;
  HttpObjects(server.plain()).put("recipe/ab/abc", "bytes");
  const Request request = server.request();
  EXPECT_EQ(request.body, "bytes");
  EXPECT_FALSE(request.headers.contains("authorization"));
  EXPECT_FALSE(request.headers.contains("expect"));
}

TEST(HttpObjects, ThatABucketHasNotGotAreNone) {
  HttpServer server(404, "<Error><Code>NoSuchKey</Code></Error>");
  EXPECT_EQ(HttpObjects(server.s3()).get("recipe/ab/abc", {}), std::nullopt);
}

TEST(HttpObjects, OfABucketThatIsNotThereAreAnOutage) {
  HttpServer server(404, "<Error><Code>NoSuchBucket</Code></Error>");
  HttpObjects objects(server.s3());
  const ErrorInfo info = error_of([&] { static_cast<void>(objects.get("recipe/ab/abc", {})); });
  EXPECT_EQ(info.reason, "TIER_UNAVAILABLE");
  EXPECT_NE(info.message.find("404 (NoSuchBucket)"), std::string::npos) << info.message;
}

/// Takes connections, and never answers.
class SilentServer {
 public:
  SilentServer() : listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    access.url = "http://127.0.0.1:" + std::to_string(listen_on_loopback(listener_)) + "/bucket";
  }
  ~SilentServer() { ::close(listener_); }
  SilentServer(const SilentServer&) = delete;
  SilentServer& operator=(const SilentServer&) = delete;

  HttpAccess access;

 private:
  const int listener_;
};

TEST(HttpObjects, OfAServerThatDoesNotAnswerInTimeAreTimedOut) {
  const SilentServer server;
  HttpObjects objects(server.access);
  EXPECT_THROW(static_cast<void>(objects.has("key", 0.05)), TierTimeout);
}

TEST(HttpObjects, ThatAreWaitedForAreLeftWhenThatIsCancelled) {
  const SilentServer server;
  HttpObjects objects(server.access);
  std::stop_source stop;
  std::jthread other([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
    stop.request_stop();
  });
  const ErrorInfo info = error_of([&] { static_cast<void>(objects.get("key", stop.get_token())); });
  EXPECT_EQ(info.kind, ErrorKind::Cancelled) << info.message;
}

TEST(HttpObjects, ThatAreRefusedTellTheCodeOfS3) {
  HttpServer server(403, "<Error><Code>RequestTimeTooSkewed</Code><Message>late</Message></Error>");
  HttpObjects objects(server.s3());
  const ErrorInfo info = error_of([&] { objects.put("recipe/ab/abc", "bytes"); });
  EXPECT_EQ(info.reason, "TIER_UNAVAILABLE");
  EXPECT_NE(info.message.find("403 (RequestTimeTooSkewed)"), std::string::npos) << info.message;
}

}  // namespace
}  // namespace remeshd::test
