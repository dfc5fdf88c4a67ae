#include <Message_ProgressIndicator.hxx>
#include <utility>

#include "engine/kernel/brep_shapes.h"

namespace remeshd::kernel {
namespace {

/// Lets a stop request break off a computation of the CAD kernel.
class StopIndicator : public Message_ProgressIndicator {
 public:
  explicit StopIndicator(std::stop_token stop) : stop_(std::move(stop)) {}

 protected:
  Standard_Boolean UserBreak() override { return stop_.stop_requested(); }
  void Show(const Message_ProgressScope&, const Standard_Boolean) override {}

 private:
  std::stop_token stop_;
};

}  // namespace

void with_progress(const Run& run, const std::function<void(const Message_ProgressRange&)>& work) {
  const Handle(StopIndicator) indicator = new StopIndicator(run.stop);
  work(indicator->Start());
  run.poll();
}

}  // namespace remeshd::kernel
