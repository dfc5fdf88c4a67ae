#pragma once

#include <functional>

namespace remeshd::kernel {

/// Does what OpenCASCADE's STEP translator needs settings for, which are the whole process's: one
/// caller at a time, the translator's messages to nowhere, its failures as Error(KERNEL_FAILURE).
void with_step_translator(const std::function<void()>& work);

}  // namespace remeshd::kernel
