#include "server/observe/readiness.h"

#include <utility>

namespace remeshd {

std::string Readiness::joined() const {
  std::string all;
  for (const auto& [input, why_not] : hindrances_)
    all += (all.empty() ? "" : "; ") + input + ": " + why_not;
  return all;
}

void Readiness::on_change(OnChange listener) {
  const std::scoped_lock lock(mutex_);
  listener_ = std::move(listener);
  if (listener_) listener_(hindrances_.empty(), joined());
}

void Readiness::set(const std::string& input, const std::string& why_not) {
  const std::scoped_lock lock(mutex_);
  const bool before = hindrances_.empty();
  if (why_not.empty())
    hindrances_.erase(input);
  else
    hindrances_[input] = why_not;
  if (listener_ && before != hindrances_.empty()) listener_(hindrances_.empty(), joined());
}

bool Readiness::ready() const {
  const std::scoped_lock lock(mutex_);
  return hindrances_.empty();
}

std::string Readiness::why_not() const {
  const std::scoped_lock lock(mutex_);
  return joined();
}

}  // namespace remeshd
