#pragma once

namespace remeshd {

/// Calls `work`, a client's listener or a job, and drops whatever it throws, so that the thread and
/// the requests of others live on.
template <typename Work>
void contained(Work&& work) {
  try {
    work();
  } catch (...) {
  }
}

}  // namespace remeshd
