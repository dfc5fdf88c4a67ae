#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace remeshd::test {

/// A certificate and its key in PEM.
struct Issued {
  std::string certificate, key;
};

/// Signs certificates, as far as a test needs it.
class Authority {
 public:
  explicit Authority(const std::string& name);
  ~Authority();
  Authority(const Authority&) = delete;
  Authority& operator=(const Authority&) = delete;

  /// Its own certificate, in PEM.
  [[nodiscard]] std::string certificate() const;
  /// For `localhost` and 127.0.0.1; valid from a day ago until `valid_for` s from now.
  [[nodiscard]] Issued issue(const std::string& name, long valid_for = 86400) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace remeshd::test
