#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/tier/object_store.h"

namespace remeshd {

struct HttpAccess {
  std::string url;  ///< `http://HOST:PORT/PREFIX`, to which keys are appended
  /// Of an S3 bucket: requests are signed (AWS signature, version 4). Empty region: they are not.
  std::string region, access_key, secret_key;
};

/// Objects over HTTP by GET, PUT and HEAD, as remote caches of builds use it, or of a bucket of S3.
class HttpObjects final : public ObjectStore {
 public:
  explicit HttpObjects(HttpAccess access);
  ~HttpObjects() override;

  [[nodiscard]] bool has(const std::string& key, double within) override;
  [[nodiscard]] std::optional<std::string> get(const std::string& key) override;
  void put(const std::string& key, const std::string& bytes) override;

 private:
  class Transfer;
  class Borrowed;
  using TransferPtr = std::unique_ptr<Transfer>;

  const HttpAccess access_;
  std::mutex mutex_;
  std::vector<TransferPtr> idle_;  ///< with connections that stay open
};

}  // namespace remeshd
