#include "server/service/motion_calls.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "proto/checksum.h"
#include "server/limits.h"
#include "server/service/revision_work.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

constexpr double kMostHold = 10;              // x edge length, as of MeshOptions.hold
constexpr std::size_t kMostParameters = 100;  // of one request: each costs vectors or trial edits

/// The parameters asked for; if none are, those of the model that are not integers. Throws Error:
/// OPTIONS_INVALID where these are too many.
template <typename Request>
std::vector<std::string> parameters_of(const Request& request, const ModelSource& source) {
  std::vector<std::string> names(request.parameters().begin(), request.parameters().end());
  if (names.empty())
    for (const ParameterSource& parameter : source.parameters)
      if (!parameter.integer) names.push_back(parameter.name);
  if (names.size() > kMostParameters)
    throw error::option_invalid("parameters", "are more than " + std::to_string(kMostParameters));
  return names;
}

std::size_t nodes_of(const OutputMesh& mesh) {
  return mesh.mesh.nodes.size() + mesh.mids.positions.size();
}

/// Bytes that computing velocities takes beside its result: a row of links for each node.
std::uint64_t memory_of_motion(const OutputMesh& mesh) {
  constexpr std::uint64_t kOfTet = 400, kOfNode = 500;
  return kOfTet * mesh.mesh.tets.size() + kOfNode * nodes_of(mesh);
}

/// The velocities, then a flag for each node where they are undefined, little-endian as in memory.
std::string bytes_of(const NodalVelocities& velocities) {
  const std::size_t bytes = velocities.velocities.size() * sizeof(Vec3);
  std::string out(bytes + velocities.undefined.size(), '\0');
  std::memcpy(out.data(), velocities.velocities.data(), bytes);
  std::memcpy(out.data() + bytes, velocities.undefined.data(), velocities.undefined.size());
  return out;
}

/// The data of all parameters on their way to the client.
struct SendingVelocities {
  std::vector<std::string> data;
  std::size_t parameter = 0, sent = 0;
};

/// Sends parts until enough of them wait for the client, and goes on once it has taken them.
void write_velocities(const std::shared_ptr<MessageStream>& stream,
                      const std::shared_ptr<SendingVelocities>& sending) {
  const auto go_on = [stream, sending] { write_velocities(stream, sending); };
  for (; sending->parameter < sending->data.size(); ++sending->parameter, sending->sent = 0) {
    const std::string& data = sending->data[sending->parameter];
    while (sending->sent < data.size()) {
      v1::GetDesignVelocitiesResponse response;
      v1::DesignVelocityPart& part = *response.mutable_part();
      part.set_parameter(static_cast<std::uint32_t>(sending->parameter));
      part.set_offset(sending->sent);
      part.set_data(data.substr(sending->sent, limits::kMeshPartBytes));
      part.set_crc32c(crc32c(part.data()));
      sending->sent += part.data().size();
      stream->send(response);
      if (stream->wait_for_client(go_on)) return;
    }
  }
  stream->end();
}

/// For the lane of computations.
void make_velocities(const std::shared_ptr<MessageStream>& stream, Session& session,
                     const v1::GetDesignVelocitiesRequest& request, const HeldRevisionPtr& held) {
  const Run run{.stop = stream->stop_token(), .on_progress = {}, .dumps = {}};
  const Revision& revision = held->revision;
  const auto names = parameters_of(request, revision.source);
  const std::uint64_t result = names.size() * nodes_of(revision.output) * (sizeof(Vec3) + 1);
  auto memory = session.take_reply_memory(2 * result + memory_of_motion(revision.output), run.stop);
  const auto all = session.velocities(revision, names, run);
  const auto sending = std::make_shared<SendingVelocities>();
  v1::GetDesignVelocitiesResponse response;
  v1::DesignVelocityHeader& header = *response.mutable_header();
  header.set_revision(held->record.id);
  header.set_nodes(static_cast<std::uint32_t>(revision.output.mesh.nodes.size()));
  header.set_mid_nodes(static_cast<std::uint32_t>(revision.output.mids.positions.size()));
  for (std::size_t k = 0; k < names.size(); ++k) {
    v1::DesignVelocityHeader::Parameter& parameter = *header.add_parameters();
    parameter.set_name(names[k]);
    parameter.set_value(all[k].value);
    parameter.set_undefined(
        static_cast<std::uint32_t>(std::ranges::count(all[k].undefined, std::uint8_t{1})));
    sending->data.push_back(bytes_of(all[k]));
  }
  if (memory) memory.resize(limits::kUntakenBytes + result);
  stream->keep(std::move(memory));
  stream->send(response);
  write_velocities(stream, sending);
}

std::vector<Vec3> seed_of(const v1::GetDesignGradientRequest& request, const OutputMesh& mesh) {
  std::vector<Vec3> seed(nodes_of(mesh));
  const std::size_t bytes = seed.size() * sizeof(Vec3);
  if (request.seed().size() != bytes)
    throw error::option_invalid("seed", "has " + std::to_string(request.seed().size()) +
                                            " bytes, where the mesh's nodes need " +
                                            std::to_string(bytes));
  std::memcpy(seed.data(), request.seed().data(), bytes);
  if (!std::ranges::all_of(seed, [](const Vec3& s) { return std::isfinite(s.x + s.y + s.z); }))
    throw error::option_invalid("seed", "has numbers that are not finite");
  return seed;
}

}  // namespace

void send_velocities(const std::shared_ptr<MessageStream>& stream, Session& session,
                     const v1::GetDesignVelocitiesRequest& request) {
  work_on_revision(stream, session, request.revision(),
                   [stream, &session, request](const HeldRevisionPtr& held) {
                     make_velocities(stream, session, request, held);
                   });
}

void reply_gradient(const std::shared_ptr<UnaryCall>& call, Session& session,
                    const v1::GetDesignGradientRequest& request) {
  work_on_revision(
      call, session, request.revision(), [call, &session, request](const HeldRevisionPtr& held) {
        const Run run{.stop = call->stop_token(), .on_progress = {}, .dumps = {}};
        const Revision& revision = held->revision;
        const auto names = parameters_of(request, revision.source);
        const std::vector<Vec3> seed = seed_of(request, revision.output);
        const auto memory = session.take_reply_memory(memory_of_motion(revision.output), run.stop);
        const auto derivatives = session.gradient(revision, seed, names, run);
        v1::GetDesignGradientResponse response;
        response.set_revision(held->record.id);
        for (std::size_t k = 0; k < names.size(); ++k) {
          v1::DesignDerivative& derivative = *response.add_derivatives();
          derivative.set_parameter(names[k]);
          derivative.set_value(derivatives[k].value);
          derivative.set_undefined(derivatives[k].undefined);
        }
        call->reply(response);
      });
}

void reply_horizons(const std::shared_ptr<UnaryCall>& call, Session& session,
                    const v1::GetConnectivityHorizonRequest& request) {
  if (request.has_hold() && !(request.hold() >= 0 && request.hold() <= kMostHold))
    throw error::option_invalid("hold", "is not between 0 and 10");
  work_on_revision(
      call, session, request.revision(), [call, &session, request](const HeldRevisionPtr& held) {
        const Run run{.stop = call->stop_token(), .on_progress = {}, .dumps = {}};
        const Revision& revision = held->revision;
        const auto memory =
            session.take_reply_memory(2 * memory_of_motion(revision.output), run.stop);
        const double hold = request.has_hold() ? request.hold() : revision.options.hold;
        v1::GetConnectivityHorizonResponse response;
        response.set_revision(held->record.id);
        for (const std::string& name : parameters_of(request, revision.source)) {
          const Horizon horizon = session.horizon(revision, name, hold, run);
          v1::ConnectivityHorizon& out = *response.add_horizons();
          out.set_parameter(name);
          out.set_value(horizon.value);
          out.set_lower(horizon.lower);
          out.set_upper(horizon.upper);
          out.set_lower_reason(horizon.lower_reason);
          out.set_upper_reason(horizon.upper_reason);
        }
        call->reply(response);
      });
}

}  // namespace remeshd
