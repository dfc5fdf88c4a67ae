// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "remesh/v1/remesh.pb.h"

namespace remeshd::client {

/// How a request that a broken stream left unanswered can be sent again. The daemon may have worked
/// on it: what is the same is then answered from its cache, but an edit of a head that it has moved
/// itself would be done a second time.
enum class Resend {
  AsItIs,     ///< it says by itself what it is made of
  OnLast,     ///< once all before it are answered, on what the last result says is the head
  Impossible  ///< its base is the head of a design that the stream knows nothing of
};

/// `last`: the last result of the stream; null before there is one.
Resend how_to_resend(const remesh::v1::EditStreamRequest& request,
                     const remesh::v1::RevisionResult* last);

/// The same request with an id as its base, in the design where it would have been filed: the head
/// of the last result's design after that result; where that is in none, what it made.
remesh::v1::EditStreamRequest on_last(remesh::v1::EditStreamRequest request,
                                      const remesh::v1::RevisionResult& last);

/// The same request, in the last result's design where it is an edit of that by its id: the id may
/// be in several, and a daemon knows the last result of its own call alone.
remesh::v1::EditStreamRequest in_design_of_last(remesh::v1::EditStreamRequest request,
                                                const remesh::v1::RevisionResult& last);

}  // namespace remeshd::client
