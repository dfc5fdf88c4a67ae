#include "server/service/verify_call.h"

#include <utility>

namespace remeshd {

namespace v1 = remesh::v1;

namespace {
constexpr std::chrono::milliseconds kProgress(500);  // at least every second is promised
}

VerifyCall* VerifyCall::start(Tenants& tenants, grpc::CallbackServerContext* context,
                              const grpc::ByteBuffer& request, std::size_t message_limit,
                              std::shared_ptr<CallRecord> record) {
  auto call = std::make_shared<VerifyCall>(context, std::move(record));
  call->self_ = call;
  answering(*call, [&] {
    call->record_->admit(*context);
    Session& session = tenants.of(call->record_->tenant());
    session.later(Lane::Preparation,
                  {.run =
                       [call, &session, bytes = grpc::ByteBuffer(request), message_limit] {
                         answering(*call, [&] {
                           v1::VerifyCacheRequest message;
                           from_bytes(bytes, message_limit, message);
                           call->verify(session, message.repair());
                         });
                       },
                   .refused = [call](const Error& why) { call->fail(why); }});
  });
  return call.get();
}

void VerifyCall::verify(Session& session, bool repair) {
  v1::VerifyCacheResponse so_far;
  auto last = std::chrono::steady_clock::now();
  const auto found = [&](const CacheFault& fault) {
    so_far.set_findings(so_far.findings() + 1);
    v1::VerifyCacheResponse message = so_far;
    message.mutable_finding()->set_revision(fault.revision);
    message.mutable_finding()->set_what(fault.what);
    message.mutable_finding()->set_repaired(fault.repaired);
    send(message);
  };
  const auto progress = [&](std::uint64_t read, std::uint64_t total) {
    so_far.set_bytes_read(read);
    so_far.set_bytes_total(total);
    const auto now = std::chrono::steady_clock::now();
    if (now - last < kProgress) return;
    last = now;
    send(so_far);
  };
  session.cache().verify_cache(repair, found, progress,
                               {.stop = stop_.get_token(), .on_progress = {}, .dumps = {}});
  so_far.set_done(true);
  send(so_far);
  end(grpc::Status::OK);
}

void VerifyCall::send(const v1::VerifyCacheResponse& message) {
  const std::scoped_lock lock(mutex_);
  if (ended_) return;
  waiting_.push_back(to_bytes(message));
  if (waiting_.size() == 1) StartWrite(&waiting_.front());
}

void VerifyCall::OnWriteDone(bool ok) {
  const auto self = shared_from_this();  // `Finish` may end the call while the lock is held
  const std::scoped_lock lock(mutex_);
  waiting_.pop_front();
  if (!ok) waiting_.clear();
  if (!waiting_.empty()) {
    StartWrite(&waiting_.front());
  } else if (ended_ && !std::exchange(finished_, true)) {
    Finish(status_);
  }
}

void VerifyCall::fail(const Error& why) noexcept {
  add_pushback(why, *context_);
  end(to_status(why), why.info().reason);
}

void VerifyCall::end(const grpc::Status& status, const std::string& reason) noexcept {
  const auto self = weak_from_this().lock();  // as in OnWriteDone
  const std::scoped_lock lock(mutex_);
  if (std::exchange(ended_, true)) return;
  record_->set_status(status, reason);
  status_ = status;
  if (waiting_.empty() && !std::exchange(finished_, true)) Finish(status_);
}

void VerifyCall::OnDone() {
  record_->end();
  const auto self = std::move(self_);
}

}  // namespace remeshd
