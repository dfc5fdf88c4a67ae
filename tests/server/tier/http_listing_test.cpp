#include "server/tier/http_listing.h"

#include <gmock/gmock.h>

namespace remeshd::test {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;

TEST(HttpListing, ReadsAFolderAsNginxListsIt) {
  const auto folder = folder_in(R"([
{ "name":"ab", "type":"directory", "mtime":"Wed, 15 Nov 2023 08:41:34 GMT" },
{ "name":"3f9c", "type":"file", "mtime":"Thu, 01 Jan 1970 00:01:00 GMT", "size":123 }
])");
  ASSERT_TRUE(folder);
  EXPECT_EQ(folder->folders, std::vector<std::string>{"ab"});
  ASSERT_EQ(folder->files.size(), 1U);
  EXPECT_EQ(folder->files[0].key, "3f9c");
  EXPECT_EQ(folder->files[0].bytes, 123U);
  EXPECT_EQ(folder->files[0].written_ns, 60 * kSecond);
  EXPECT_FALSE(folder_in("<html>Index of /</html>"));
  EXPECT_FALSE(folder_in(R"([{"name": "a"}])"));
  EXPECT_TRUE(folder_in("[]")->files.empty());
}

TEST(HttpListing, ReadsAPageOfABucket) {
  const auto page = bucket_in(R"(<?xml version="1.0" encoding="UTF-8"?>
<ListBucketResult xmlns="http://s3.amazonaws.com/doc/2006-03-01/"><Name>b</Name>
<IsTruncated>true</IsTruncated><NextContinuationToken>1ue/=</NextContinuationToken>
<Contents><Key>farm/pack/ab/3f</Key><LastModified>1970-01-01T00:01:00.000Z</LastModified>
<Size>434234</Size></Contents></ListBucketResult>)");
  ASSERT_TRUE(page);
  EXPECT_EQ(page->next, "1ue/=");
  ASSERT_EQ(page->objects.size(), 1U);
  EXPECT_EQ(page->objects[0].key, "farm/pack/ab/3f");
  EXPECT_EQ(page->objects[0].bytes, 434234U);
  EXPECT_EQ(page->objects[0].written_ns, 60 * kSecond);
  EXPECT_FALSE(bucket_in("<Error/>"));
  EXPECT_FALSE(bucket_in("nothing"));
}

TEST(HttpListing, WithATimeThatSaysNothingIsNone) {
  // An object that seems old is one that nobody needs.
  EXPECT_FALSE(folder_in(R"([{ "name":"3f9c", "type":"file", "mtime":"yesterday", "size":123 }])"));
  EXPECT_FALSE(bucket_in(
      "<ListBucketResult><Contents><Key>a</Key><Size>1</Size></Contents></ListBucketResult>"));
}

TEST(HttpListing, FindsTheBucketInAnAddress) {
  const auto expect = [](const std::string& url, const std::string& bucket,
                         const std::string& prefix) {
    EXPECT_EQ(bucket_address(url).url, bucket);
    EXPECT_EQ(bucket_address(url).prefix, prefix);
  };
  expect("http://10.0.0.1:8080/bucket", "http://10.0.0.1:8080/bucket", "");
  expect("http://10.0.0.1:8080/bucket/shared/a", "http://10.0.0.1:8080/bucket", "shared/a/");
  expect("https://bucket.s3.eu-west-1.example.org/farm", "https://bucket.s3.eu-west-1.example.org",
         "farm/");
  expect("https://bucket.s3.eu-west-1.example.org", "https://bucket.s3.eu-west-1.example.org", "");
  EXPECT_EQ(query_escaped("farm/pack/"), "farm%2Fpack%2F");
}

}  // namespace
}  // namespace remeshd::test
