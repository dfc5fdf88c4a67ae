#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <vector>

#include "server/tier/object_store.h"

namespace remeshd {

class HttpTransfer;

struct HttpAccess {
  std::string url;  ///< `http://HOST:PORT/PREFIX`, to which keys are appended
  /// For an S3 bucket, whose requests are signed (AWS signature, version 4). Empty region: a plain
  /// server, and no signature.
  std::string region, access_key, secret_key;
};

/// Objects on an HTTP server by GET, PUT and HEAD, as remote build caches use it, or in an S3
/// bucket. For garbage collection a plain server also has to support DELETE, and to answer GET of a
/// folder with a list in nginx's JSON format.
class HttpObjects final : public ObjectStore {
 public:
  explicit HttpObjects(HttpAccess access);
  ~HttpObjects() override;

  [[nodiscard]] bool has(const std::string& key, double within) override;
  [[nodiscard]] std::optional<std::string> get(const std::string& key,
                                               const std::stop_token& stop) override;
  void put(const std::string& key, const std::string& bytes) override;
  [[nodiscard]] std::optional<std::string> start_of(const std::string& key,
                                                    std::size_t bytes) override;
  void list(const std::string& prefix,
            const std::function<void(const ObjectInfo&)>& visit) override;
  void remove(const std::string& key) override;

 private:
  class Borrowed;

  [[nodiscard]] std::string url_of(const std::string& key) const;
  void list_folder(const std::string& folder, const std::function<void(const ObjectInfo&)>& visit);
  void list_bucket(const std::string& prefix, const std::function<void(const ObjectInfo&)>& visit);

  const HttpAccess access_;
  std::mutex mutex_;
  std::vector<std::unique_ptr<HttpTransfer>> idle_;  ///< with connections that stay open
};

}  // namespace remeshd
