#pragma once

#include <cstddef>
#include <stop_token>
#include <string>

#include "server/tier/http_objects.h"

struct curl_slist;

namespace remeshd {

/// One HTTP request after another, over a connection that stays open.
class HttpTransfer {
 public:
  /// `access` must outlive it.
  explicit HttpTransfer(const HttpAccess& access);
  ~HttpTransfer();
  HttpTransfer(const HttpTransfer&) = delete;
  HttpTransfer& operator=(const HttpTransfer&) = delete;

  enum class Method { Get, Head, Put, Delete };
  struct Request {
    Method method = Method::Get;
    std::string url;
    double seconds = 60;                ///< that it may take
    const std::string* body = nullptr;  ///< of PUT
    std::size_t most = 0;               ///< bytes of the answer that are wanted; 0: all
    std::stop_token stop{};             ///< ends it, within about a second
  };
  struct Answer {
    bool found = false;  ///< else its status is 404
    std::string body;
  };
  /// Throws Error: TIER_REFUSED where the object is too large for the server, else TIER_UNAVAILABLE
  /// for any failure but a missing object (status 404), and Cancelled.
  Answer ask(const Request& request);

 private:
  void begin(const Request& request);
  void sign(const std::string& body);
  void add_header(const char* line);
  template <typename Option, typename Value>
  void set(Option option, Value value);

  const HttpAccess& access_;
  void* const curl_;
  curl_slist* headers_ = nullptr;
  std::string body_;
};

}  // namespace remeshd
