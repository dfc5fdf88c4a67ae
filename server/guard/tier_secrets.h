#pragma once

#include <filesystem>

#include "server/tier/sharing.h"

namespace remeshd {

/// Reads the farm's key, one word of 16 characters or more, and, where it is named, the file of an
/// S3 bucket's keys, `ACCESS_KEY SECRET_KEY`. Throws SecretFileError.
TierSecrets read_tier_secrets(const std::filesystem::path& key_file,
                              const std::filesystem::path& s3_credentials_file);

}  // namespace remeshd
