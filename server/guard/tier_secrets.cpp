#include "server/guard/tier_secrets.h"

#include <sstream>
#include <string>

#include "server/guard/secret_file.h"

namespace remeshd {
namespace {

constexpr std::size_t kShortestKey = 16;

}  // namespace

TierSecrets read_tier_secrets(const std::filesystem::path& key_file,
                              const std::filesystem::path& s3_credentials_file) {
  TierSecrets secrets;
  std::string more;
  std::istringstream key(read_secret_file(key_file));
  if (!(key >> secrets.farm_key) || key >> more || secrets.farm_key.size() < kShortestKey)
    throw SecretFileError(key_file.string() + ": is to have one word, of 16 characters or more");
  if (s3_credentials_file.empty()) return secrets;
  std::istringstream keys(read_secret_file(s3_credentials_file));
  if (!(keys >> secrets.access_key >> secrets.secret_key) || keys >> more)
    throw SecretFileError(s3_credentials_file.string() +
                          ": is to have two words, `ACCESS_KEY SECRET_KEY`");
  return secrets;
}

}  // namespace remeshd
