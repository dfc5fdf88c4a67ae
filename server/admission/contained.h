#pragma once

namespace remeshd {

/// Calls what must not throw, a client's listener or a job: whatever it throws all the same ends
/// here, so that the thread and everybody else's requests live on.
template <typename Work>
void contained(Work&& work) {
  try {
    work();
  } catch (...) {
  }
}

}  // namespace remeshd
