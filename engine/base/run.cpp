#include "engine/base/run.h"

#include "engine/base/error.h"

namespace remeshd {

void Run::poll() const {
  if (stop.stop_requested()) throw error::cancelled();
}

void Run::report(std::string_view stage, double fraction, int iteration) const {
  poll();
  if (on_progress) on_progress({stage, iteration, fraction});
}

void Run::warn(std::span<const Warning> certain) const {
  if (on_warnings && !certain.empty()) on_warnings(certain);
  poll();
}

}  // namespace remeshd
