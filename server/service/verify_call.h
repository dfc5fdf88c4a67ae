#pragma once

#include <memory>

#include "remesh/v1/cache.pb.h"
#include "server/service/message_stream.h"
#include "server/session/session.h"

namespace remeshd {

/// Answers a VerifyCache: all that is stored is read, and what is found is sent as it comes. While
/// a mesh is made again, or the client has to take what waits for it, no thread waits. For the lane
/// of preparations.
void verify_cache(const std::shared_ptr<MessageStream>& stream, Session& session,
                  const remesh::v1::VerifyCacheRequest& request);

}  // namespace remeshd
