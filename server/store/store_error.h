#pragma once

#include <string_view>

#include "engine/base/error.h"

namespace remeshd::error {

/// The disk refused; a full one is ResourceExhausted, anything else Internal.
Error store_failed(std::string_view doing, std::string_view path, int error_number);
/// What was read is not what was written.
Error store_corrupted(std::string_view path, std::string_view what);
/// Another process has the store.
Error store_locked(std::string_view path);

}  // namespace remeshd::error
