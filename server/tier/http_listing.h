#pragma once

#include <optional>
#include <string>
#include <vector>

#include "server/tier/object_store.h"

namespace remeshd {

/// Lists of objects as servers answer them.

/// A folder as nginx lists it with `autoindex_format json`.
struct ListedFolder {
  std::vector<ObjectInfo> files;     ///< with their names for keys
  std::vector<std::string> folders;  ///< names
};
/// Nothing where the text is no such list.
std::optional<ListedFolder> folder_in(const std::string& json);

/// A page of a bucket, as S3's ListObjectsV2 answers it.
struct ListedBucket {
  std::vector<ObjectInfo> objects;
  std::string next;  ///< token of the next page; empty for the last
};
std::optional<ListedBucket> bucket_in(const std::string& xml);

/// The bucket of a URL that objects are appended to, and what their keys begin with there: of
/// `https://HOST/BUCKET/PREFIX`, and of `https://BUCKET.s3.REGION.HOST/PREFIX`.
struct BucketAddress {
  std::string url;     ///< without a slash at the end
  std::string prefix;  ///< empty, or with a slash at the end
};
BucketAddress bucket_address(const std::string& url);

/// As in the query of a URL.
std::string query_escaped(const std::string& text);

}  // namespace remeshd
