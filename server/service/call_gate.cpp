#include "server/service/call_gate.h"

#include <condition_variable>
#include <mutex>

#include "server/admission/load_error.h"

namespace remeshd {

struct CallGate::State {
  mutable std::mutex mutex;
  std::condition_variable empty;
  std::size_t inside = 0;
  bool closed = false;
};

CallGate::CallGate() : state_(std::make_shared<State>()) {}

CallGate::Pass CallGate::enter() {
  {
    const std::scoped_lock lock(state_->mutex);
    if (state_->closed) throw error::shutting_down();
    ++state_->inside;
  }
  // Where there is no memory for the pass, its deleter is called at once.
  return {state_.get(), [state = state_](void*) {
            const std::scoped_lock lock(state->mutex);
            if (--state->inside == 0) state->empty.notify_all();
          }};
}

void CallGate::close() {
  const std::scoped_lock lock(state_->mutex);
  state_->closed = true;
}

bool CallGate::closed() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->closed;
}

bool CallGate::wait_until_empty(std::chrono::duration<double> limit) {
  std::unique_lock lock(state_->mutex);
  return state_->empty.wait_for(lock, limit, [this] { return state_->inside == 0; });
}

}  // namespace remeshd
