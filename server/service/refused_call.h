#pragma once

#include <memory>
#include <utility>

#include "server/service/call.h"
#include "server/service/status.h"

namespace remeshd {

/// A call of any kind that ends before it has begun. Deletes itself.
template <typename Reactor>
class RefusedCall final : public Reactor {
 public:
  RefusedCall(grpc::CallbackServerContext* context, const Error& why,
              std::shared_ptr<CallRecord> record)
      : record_(std::move(record)) {
    add_pushback(why, *context);
    const grpc::Status status = to_status(why);
    record_->set_status(status, why.info().reason);
    this->Finish(status);
  }
  void OnDone() override {
    record_->end();
    delete this;
  }
  void OnCancel() override {}

 private:
  const std::shared_ptr<CallRecord> record_;
};

}  // namespace remeshd
