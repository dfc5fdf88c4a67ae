#include "server/service/call.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/io/zero_copy_stream_impl_lite.h>
#include <google/protobuf/stubs/logging.h>
#include <grpcpp/support/proto_buffer_reader.h>

#include <optional>
#include <utility>

#include "server/service/status.h"
#include "server/service/trace_parent.h"

namespace remeshd {
namespace {

const char* name_of(grpc::StatusCode code) {
  static constexpr const char* kNames[] = {"OK",
                                           "CANCELLED",
                                           "UNKNOWN",
                                           "INVALID_ARGUMENT",
                                           "DEADLINE_EXCEEDED",
                                           "NOT_FOUND",
                                           "ALREADY_EXISTS",
                                           "PERMISSION_DENIED",
                                           "RESOURCE_EXHAUSTED",
                                           "FAILED_PRECONDITION",
                                           "ABORTED",
                                           "OUT_OF_RANGE",
                                           "UNIMPLEMENTED",
                                           "INTERNAL",
                                           "UNAVAILABLE",
                                           "DATA_LOSS",
                                           "UNAUTHENTICATED"};
  return code >= 0 && code <= grpc::StatusCode::UNAUTHENTICATED ? kNames[code] : "UNKNOWN";
}

Error unreadable(std::string reason, std::string message, std::string hint) {
  ErrorInfo info;
  info.kind = ErrorKind::InvalidArgument;
  info.reason = std::move(reason);
  info.message = std::move(message);
  info.stage = "request";
  info.hint = std::move(hint);
  return Error(std::move(info));
}

Error damaged() {
  return unreadable("MESSAGE_UNREADABLE",
                    "the message cannot be read: it is cut off, has a text that is not UTF-8, or "
                    "its values are nested too deep",
                    "lists and objects may be nested at most 40 deep");
}

void parse(google::protobuf::io::ZeroCopyInputStream& bytes, google::protobuf::Message& message) {
  // protobuf writes what it dislikes to stderr; here the client gets to know it instead.
  const google::protobuf::LogSilencer silence;
  if (!message.ParseFromZeroCopyStream(&bytes)) throw damaged();
}

/// A client's text as it goes into the log: 128 bytes at most, without blanks and control
/// characters.
std::string loggable(std::string text) {
  if (text.size() > 128) text.resize(128);
  for (char& c : text)
    if (static_cast<unsigned char>(c) <= 0x20 || c == 0x7F) c = '_';
  return text;
}

/// The client's `traceparent`, where it sent one that is valid: nothing else goes into the log.
std::string trace_parent_of(const grpc::ServerContextBase& context) {
  const auto& metadata = context.client_metadata();
  const auto sent = metadata.find("traceparent");
  if (sent == metadata.end()) return "";
  const std::string_view text(sent->second.data(), sent->second.size());
  return is_trace_parent(text) ? std::string(text) : "";
}

/// The client's `authorization` metadata, where it sent any.
std::optional<std::string_view> authorization_of(const grpc::ServerContextBase& context) {
  const auto& metadata = context.client_metadata();
  const auto sent = metadata.find("authorization");
  if (sent == metadata.end()) return std::nullopt;
  return std::string_view(sent->second.data(), sent->second.size());
}

/// Counts the end of a call, and counts it as a refusal where its code is one.
void count(Metrics& metrics, const std::string& method, const std::string& code,
           const std::string& reason, double seconds) noexcept {
  metrics.call_ended(method, code, seconds);
  for (const std::string_view refusal :
       {"RESOURCE_EXHAUSTED", "UNAVAILABLE", "UNAUTHENTICATED", "PERMISSION_DENIED"})
    if (code == refusal && !reason.empty()) metrics.refused(reason);
}

}  // namespace

grpc::ByteBuffer to_bytes(const google::protobuf::Message& message) {
  // Serialised straight into the slice that gRPC sends: a mesh's part is a megabyte.
  const std::size_t size = message.ByteSizeLong();
  const grpc::Slice slice(grpc_slice_malloc_large(size), grpc::Slice::STEAL_REF);
  google::protobuf::io::ArrayOutputStream stream(const_cast<std::uint8_t*>(slice.begin()),
                                                 static_cast<int>(size));
  google::protobuf::io::CodedOutputStream coded(&stream);
  coded.SetSerializationDeterministic(true);
  message.SerializeWithCachedSizes(&coded);
  return {&slice, 1};
}

void check_size(std::size_t bytes, std::size_t limit) {
  if (bytes > limit)
    throw unreadable("MESSAGE_TOO_LARGE",
                     "the message has " + std::to_string(bytes) +
                         " bytes, more than the limit of " + std::to_string(limit),
                     "send a smaller document");
}

void from_bytes(const grpc::ByteBuffer& bytes, std::size_t limit,
                google::protobuf::Message& message) {
  check_size(bytes.Length(), limit);
  grpc::ByteBuffer copy(bytes);
  grpc::ProtoBufferReader reader(&copy);
  if (!reader.status().ok()) throw damaged();
  parse(reader, message);
}

void from_bytes(std::string_view bytes, std::size_t limit, google::protobuf::Message& message) {
  check_size(bytes.size(), limit);
  google::protobuf::io::ArrayInputStream reader(bytes.data(), static_cast<int>(bytes.size()));
  parse(reader, message);
}

CallRecord::CallRecord(FrontDeskPtr desk, std::string method,
                       const grpc::ServerContextBase& context)
    : desk_(std::move(desk)),
      method_(std::move(method)),
      peer_(context.peer()),
      trace_parent_(trace_parent_of(context)) {
  static std::atomic<std::uint64_t> counter{0};
  number_ = ++counter;
}

void CallRecord::admit(const grpc::ServerContextBase& context) {
  admit_stream(context);
  pass_ = enter();
}

void CallRecord::admit_stream(const grpc::ServerContextBase& context) {
  if (desk_->doorman) tenant_ = desk_->doorman->tenant_of(authorization_of(context));
}

void CallRecord::check_still_admitted(const grpc::ServerContextBase& context) const {
  if (desk_->doorman) desk_->doorman->check_again(authorization_of(context), tenant_);
}

void CallRecord::set_request_id(std::string id) {
  const std::scoped_lock lock(mutex_);
  request_id_ = loggable(std::move(id));
}
void CallRecord::set_status(const grpc::Status& status, const std::string& reason) noexcept {
  const std::scoped_lock lock(mutex_);
  status_ = name_of(status.error_code());
  try {
    reason_ = reason;
  } catch (...) {
    reason_.clear();
  }
}
void CallRecord::set_note(std::string note) {
  const std::scoped_lock lock(mutex_);
  note_ = std::move(note);
}

void CallRecord::count_as_stream() {
  if (!std::exchange(streams_, true)) ++*desk_->streams;
}

void CallRecord::count_request(grpc::StatusCode code, const std::string& reason,
                               double seconds) const noexcept try {
  if (desk_->metrics) count(*desk_->metrics, method_ + ".request", name_of(code), reason, seconds);
} catch (...) {
}

void CallRecord::end() noexcept try {
  const std::scoped_lock lock(mutex_);
  pass_.reset();
  if (std::exchange(streams_, false)) --*desk_->streams;
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
  if (desk_->metrics) {
    count(*desk_->metrics, method_, status_, reason_, spent.count());
  }
  if (!desk_->log) return;
  std::string line = fmt::format("call={} method={} peer={} ms={:.1f} status={}", number_, method_,
                                 peer_, 1000 * spent.count(), status_);
  if (!tenant_.empty()) line += " tenant=" + tenant_;
  if (!request_id_.empty()) line += " request=" + request_id_;
  if (!reason_.empty()) line += " reason=" + reason_;
  if (!note_.empty()) line += " " + note_;
  if (!trace_parent_.empty()) line += " traceparent=" + trace_parent_;
  desk_->log->info(line);
} catch (...) {
}

grpc::ServerUnaryReactor* refuse(grpc::CallbackServerContext& context, CallRecord& record,
                                 const Error& why) noexcept {
  // gRPC ends its default reactor on the thread on which the call came in, others on another one.
  grpc::ServerUnaryReactor* const reactor = context.DefaultReactor();
  const grpc::Status status = to_status(why);
  add_pushback(why, context);
  record.set_status(status, why.info().reason);
  record.end();
  reactor->Finish(status);
  return reactor;
}

std::shared_ptr<UnaryCall> UnaryCall::start(grpc::CallbackServerContext* context,
                                            grpc::ByteBuffer* reply,
                                            std::shared_ptr<CallRecord> record) {
  auto call = std::make_shared<UnaryCall>(context, reply, std::move(record));
  call->self_ = call;
  return call;
}

void UnaryCall::reply(const google::protobuf::Message& message) {
  grpc::ByteBuffer bytes = to_bytes(message);  // may throw: not after the call counts as ended
  if (ended_.exchange(true)) return;
  reply_->Swap(&bytes);
  record_->set_status(grpc::Status::OK);
  Finish(grpc::Status::OK);
}

void UnaryCall::fail(const Error& error) noexcept {
  if (ended_.exchange(true)) return;
  add_pushback(error, *context_);
  finish(to_status(error), error.info().reason);
}

void UnaryCall::give_up() noexcept {
  if (!ended_.exchange(true)) finish(out_of_memory_status());
}

void UnaryCall::finish(const grpc::Status& status, const std::string& reason) noexcept {
  record_->set_status(status, reason);
  Finish(status);
}

void UnaryCall::on_cancel(std::function<void()> action) {
  {
    const std::scoped_lock lock(mutex_);
    if (done_) return;
    if (!cancelled_) {
      on_cancel_.push_back(std::move(action));
      return;
    }
  }
  action();
}

void UnaryCall::OnCancel() {
  std::vector<std::function<void()>> actions;
  {
    const std::scoped_lock lock(mutex_);
    cancelled_ = true;
    actions.swap(on_cancel_);
  }
  stop_.request_stop();
  for (const auto& action : actions) answering(*this, action);
}

void UnaryCall::OnDone() {
  record_->end();
  {
    // The actions may hold shared_ptrs to this call.
    const std::scoped_lock lock(mutex_);
    done_ = true;
    on_cancel_.clear();
  }
  // This may be the last shared_ptr to the call.
  const auto self = std::move(self_);
}

}  // namespace remeshd
