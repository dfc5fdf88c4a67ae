#pragma once

#include <functional>

namespace remeshd::kernel {

/// Calls `work`, which may use OpenCASCADE's STEP translator. Its settings are global to the
/// process: one caller at a time. Messages of the translator are discarded, its failures become
/// Error(KERNEL_FAILURE).
void with_step_translator(const std::function<void()>& work);

}  // namespace remeshd::kernel
