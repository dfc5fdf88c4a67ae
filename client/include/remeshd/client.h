// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "remesh/v1/cache.pb.h"
#include "remesh/v1/remesh.pb.h"
#include "remeshd/call_options.h"
#include "remeshd/edit_stream.h"
#include "remeshd/error.h"
#include "remeshd/mesh.h"
#include "remeshd/mesh_wanted.h"

namespace grpc {
class Channel;
}

namespace remeshd::client {

struct ConnectOptions {
  /// s between keepalive pings while a call is open; the connection is given up 20 s after a ping
  /// that stays unanswered (a shorter limit would cut slow but live readers).
  int keepalive = 60;
  /// PEM texts for TLS; all empty: a connection without encryption. With a certificate and key the
  /// client shows who it is.
  std::string root_certificates, certificate, private_key;
  /// What the daemon knows this client by, where it asks for tokens; sent with each call, over TLS,
  /// to this machine or over a Unix socket only.
  std::string token;
};

/// Part of a mesh transfer so far: bytes received and bytes in all.
using OnTransfer = std::function<void(std::uint64_t done, std::uint64_t total)>;

/// A connection to a daemon `remeshd`, or to several that share a tier. Cheap to copy; all
/// functions may be called from any thread.
///
/// Where there are several daemons, the requests of one loop go to the same daemon, chosen by
/// CallOptions::route, and to the next one if that does not answer or is not available: a repeated
/// request for a revision does not make it twice. Other requests that change something are not
/// repeated where they may have been carried out. Where the home of a design is another daemon
/// (DESIGN_ELSEWHERE), the client asks that one, if it has its address. A list comes from one
/// daemon only: that of a design's revisions from the daemon that the design's route leads to.
///
/// Every function throws CallError. Where a request names a revision it takes the name of a design
/// (its head), `design@number`, an id or a unique prefix of at least 8 digits. Where one takes a
/// model or an edit it takes the JSON text of a document instead; one of more than 4 MiB is not
/// sent: INVALID_ARGUMENT, DOCUMENT_TOO_LARGE.
class Client {
 public:
  /// Prepares a connection to `host:port` or `unix:/path`, or to several with commas between; the
  /// first call connects. Throws INVALID_ARGUMENT for no address, and for a token that would be
  /// sent unencrypted to another machine.
  static Client connect(const std::string& addresses, const ConnectOptions& options = {});
  /// The same of a list.
  static Client connect_any(const std::vector<std::string>& addresses,
                            const ConnectOptions& options = {});
  /// Uses a channel of the caller's making: other credentials, or a server in the same process.
  explicit Client(std::shared_ptr<grpc::Channel> channel);

  /// Meshes a model. The same request again is answered from the cache.
  [[nodiscard]] remesh::v1::RevisionResult create_revision(
      const remesh::v1::CreateRevisionRequest& request, const CallOptions& call = {}) const;
  /// Remeshes a revision after an edit of its model.
  [[nodiscard]] remesh::v1::RevisionResult edit_revision(
      const remesh::v1::EditRevisionRequest& request, const CallOptions& call = {}) const;
  /// Opens a stream of edits. A stop request breaks the stream off.
  [[nodiscard]] EditStream stream(EditStream::OnProgress on_progress = {},
                                  const CallOptions& call = {}) const;

  /// Fetches the mesh of a revision, or those arrays of it that are wanted. All its checksums,
  /// digests, counts and indices have been checked; DATA_LOSS, MESH_DAMAGED where one is wrong.
  [[nodiscard]] Mesh get_mesh(const std::string& revision, const CallOptions& call = {},
                              const OnTransfer& on_transfer = {},
                              const MeshWanted& wanted = {}) const;
  /// The bytes of the mesh as the daemon writes it to a file, `vtu`, `msh` or `inp`, or of the
  /// exact boundary of its model, `step`, as `info().capabilities().formats()` tells. Checked as
  /// `get_mesh` does.
  [[nodiscard]] std::string get_mesh_file(const std::string& revision, const std::string& format,
                                          const CallOptions& call = {},
                                          const OnTransfer& on_transfer = {}) const;

  /// Everything about a revision but its mesh.
  [[nodiscard]] remesh::v1::GetRevisionResponse get_revision(const std::string& revision,
                                                             const CallOptions& call = {}) const;
  /// The recipe of a revision, from which its mesh can be made again, as a message and as JSON.
  [[nodiscard]] remesh::v1::GetRecipeResponse get_recipe(const std::string& revision,
                                                         const CallOptions& call = {}) const;
  /// Makes a new revision from the recipe of one, with the algorithm that the daemon has today.
  [[nodiscard]] remesh::v1::RemakeRevisionResponse remake_revision(
      const remesh::v1::RemakeRevisionRequest& request, const CallOptions& call = {}) const;
  /// All revisions that pass the filter, in the order asked for; a page token in the request is
  /// ignored.
  [[nodiscard]] std::vector<remesh::v1::RevisionInfo> list_revisions(
      remesh::v1::ListRevisionsRequest request = {}, const CallOptions& call = {}) const;
  /// The revisions of one design by number; NOT_FOUND if there is no such design.
  [[nodiscard]] std::vector<remesh::v1::RevisionInfo> log(const std::string& design,
                                                          const CallOptions& call = {}) const;
  /// All designs that pass the filter, in the order asked for.
  [[nodiscard]] std::vector<remesh::v1::DesignInfo> list_designs(
      remesh::v1::ListDesignsRequest request = {}, const CallOptions& call = {}) const;
  /// Makes a revision the head of a design that has it.
  remesh::v1::SetHeadResponse set_head(const remesh::v1::SetHeadRequest& request,
                                       const CallOptions& call = {}) const;
  /// Removes a revision; the head of a design only where `allow_head` is true.
  remesh::v1::DeleteRevisionResponse delete_revision(const std::string& revision,
                                                     bool allow_head = false,
                                                     const CallOptions& call = {}) const;
  /// Removes a design with all its revisions, its head too.
  remesh::v1::DeleteDesignResponse delete_design(const remesh::v1::DeleteDesignRequest& request,
                                                 const CallOptions& call = {}) const;

  /// The difference model of two models or revisions, or of one and an edit of it.
  [[nodiscard]] remesh::v1::Comparison compare(const remesh::v1::CompareRequest& request,
                                               const CallOptions& call = {}) const;
  /// Checks a model without meshing it.
  [[nodiscard]] remesh::v1::ModelCheck validate(const remesh::v1::ValidateModelRequest& request,
                                                const CallOptions& call = {}) const;
  /// Checks an edit and the model that it makes.
  [[nodiscard]] remesh::v1::ModelCheck validate(const remesh::v1::ValidateEditRequest& request,
                                                const CallOptions& call = {}) const;
  /// The types of features that the daemon knows.
  [[nodiscard]] std::vector<remesh::v1::FeatureType> types(const CallOptions& call = {}) const;
  /// Version, capabilities, limits and load of the daemon.
  [[nodiscard]] remesh::v1::ServerInfo info(const CallOptions& call = {}) const;

  // For operators: the meshes that one daemon holds. INVALID_ARGUMENT where there are several.

  /// All entries that pass the filter, in the order asked for.
  [[nodiscard]] std::vector<remesh::v1::CacheEntry> list_cache(
      remesh::v1::ListCacheEntriesRequest request = {}, const CallOptions& call = {}) const;
  [[nodiscard]] remesh::v1::GetCacheStatsResponse cache_stats(const CallOptions& call = {}) const;
  /// Drops meshes until a budget is kept.
  remesh::v1::CollectGarbageResponse collect_garbage(
      const remesh::v1::CollectGarbageRequest& request, const CallOptions& call = {}) const;
  /// Compares everything stored with its checksums; calls `on_message` with each finding and with
  /// the progress. Returns the last message.
  remesh::v1::VerifyCacheResponse verify_cache(
      bool repair, const std::function<void(const remesh::v1::VerifyCacheResponse&)>& on_message,
      const CallOptions& call = {}) const;
  /// Pins a mesh, so that it is not dropped, or unpins it.
  remesh::v1::CacheEntry set_pin(const std::string& revision, bool pinned,
                                 const CallOptions& call = {}) const;

 private:
  struct Impl;
  explicit Client(std::shared_ptr<const Impl> impl);
  std::shared_ptr<const Impl> impl_;
};

}  // namespace remeshd::client
