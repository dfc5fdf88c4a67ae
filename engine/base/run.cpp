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

}  // namespace remeshd
