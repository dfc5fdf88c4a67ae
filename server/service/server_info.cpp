#include "server/service/server_info.h"

#include "server/service/mesh_file.h"
#include "server/service/mesh_messages.h"
#include "server/service/stream_queue.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

template <typename Number>
std::uint32_t count_of(Number number) {
  return static_cast<std::uint32_t>(number);
}

void put_limits(const Session& session, const ServerFacts& facts, const RequestLimits& requests,
                v1::ServerLimits& out) {
  const SessionLimits& limits = session.limits();
  out.set_document_bytes(requests.document.bytes);
  out.set_message_bytes(requests.message_bytes);
  out.set_nodes(limits.max_nodes);
  out.set_threads(count_of(limits.threads));
  out.set_workers(count_of(limits.workers));
  out.set_queue(count_of(limits.queue));
  out.set_queue_seconds(limits.wait);
  out.set_compute_seconds(limits.compute);
  out.set_connections(facts.connections);
  out.set_streams(facts.streams);
  out.set_stream_requests(count_of(StreamQueue::Limits{}.requests));
  out.set_memory_bytes(limits.memory);
  out.set_disk_bytes(limits.disk);
}

void put_load(Session& session, const ServerFacts& facts, v1::ServerLoad& out) {
  const Load load = session.load();
  out.set_running(count_of(load.running));
  out.set_queued(count_of(load.queued));
  if (facts.open_connections) out.set_connections(count_of(facts.open_connections()));
  if (facts.open_streams) out.set_streams(count_of(facts.open_streams()));
  out.set_revisions(load.revisions);
  out.set_designs(load.designs);
  out.set_cached_revisions(count_of(load.held));
  out.set_memory_bytes(load.memory_bytes);
  out.set_disk_bytes(load.disk_bytes);
  out.set_persistent(session.persistent());
}

}  // namespace

v1::ServerInfo server_info(Session& session, const ServerFacts& facts,
                           const RequestLimits& limits) {
  v1::ServerInfo out;
  out.set_version(facts.version);
  out.set_protocol("remesh.v1");
  out.set_algorithm_version(session.algorithm_version());
  out.mutable_started()->set_seconds(
      std::chrono::duration_cast<std::chrono::seconds>(facts.started.time_since_epoch()).count());
  if (facts.readiness != nullptr) out.set_not_ready(facts.readiness->why_not());
  out.set_ready(out.not_ready().empty());
  for (const auto capability :
       {v1::ServerCapabilities::CAPABILITY_SIZING, v1::ServerCapabilities::CAPABILITY_SIZES,
        v1::ServerCapabilities::CAPABILITY_GROUPS, v1::ServerCapabilities::CAPABILITY_AUDIT,
        v1::ServerCapabilities::CAPABILITY_FORECAST, v1::ServerCapabilities::CAPABILITY_MESH_DELTA,
        v1::ServerCapabilities::CAPABILITY_REMAKE, v1::ServerCapabilities::CAPABILITY_CACHE,
        v1::ServerCapabilities::CAPABILITY_HOLD, v1::ServerCapabilities::CAPABILITY_VELOCITIES})
    out.mutable_capabilities()->add_capabilities(capability);
  for (const std::uint32_t order : {1U, 2U}) out.mutable_capabilities()->add_orders(order);
  for (const v1::MeshArray array : supported_arrays())
    out.mutable_capabilities()->add_arrays(array);
  for (const std::string& format : mesh_file_formats())
    out.mutable_capabilities()->add_formats(format);
  put_limits(session, facts, limits, *out.mutable_limits());
  put_load(session, facts, *out.mutable_load());
  return out;
}

}  // namespace remeshd
