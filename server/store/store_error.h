#pragma once

#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

/// An operation on the disk failed: STORE_FULL (ResourceExhausted) for a full disk, else
/// STORE_FAILED (Internal). `path`: only its last part is told.
Error store_failed(std::string_view doing, std::string_view path, int error_number);
/// What was read of a revision is not what was written.
Error store_corrupted(std::string_view id, std::string_view what);
/// Another process has the store.
Error store_locked(std::string_view path);
/// A folder that holds something else, `example` for one, is not made a store.
Error store_foreign(std::string_view path, std::string_view example);
/// The store is of a version that this program does not know.
Error store_newer(std::string_view path, int version, int known);

}  // namespace remeshd::error
