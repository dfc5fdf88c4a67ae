#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "tests/bench/sample.h"

namespace remeshd::bench {

/// Node counts that differ by no more than this share count as the same.
inline constexpr double kSameNodes = 0.02;

/// A mesher that ours is compared with.
struct Peer {
  std::string name;   ///< of its series: `hxt`
  std::string title;  ///< in tables
  /// Asked for more nodes, it is left out by default: it would take the better part of a day.
  std::uint32_t most_nodes;
};

/// Gmsh with HXT and with its Delaunay mesher, both optimised, TetGen on Gmsh's surface, Netgen.
const std::vector<Peer>& all_peers();
/// Throws std::runtime_error where there is none of this name.
const Peer& peer_named(const std::string& name);

/// The peers at work on one geometry. Each meshes in a process of its own, with one thread.
class PeerSession {
 public:
  /// Builds the merged solid of a model document in `folder`, where the sizes that lead to a number
  /// of nodes are kept too. `sized`: peers take the curvature into account.
  ///
  /// Throws std::runtime_error where its volume is not `exact_volume`, or `remesh-peer-gmsh` is not
  /// there.
  PeerSession(std::filesystem::path folder, const std::string& name, const std::string& model_file,
              double exact_volume, bool sized, double limit_seconds);

  /// Faces of their geometry.
  [[nodiscard]] std::size_t faces() const { return faces_; }

  /// A mesh of so many nodes, within `kSameNodes`, or the nearest there is: Netgen fills the inside
  /// by levels of an octree, each of eight times the nodes. Which edge length leads there is found
  /// out the first time, apart from the run that is measured. `start`: an edge length to begin
  /// with.
  Sample run(const Peer& peer, std::uint32_t nodes, double start);

 private:
  /// An edge length and the nodes it gives.
  struct Size {
    double size = 0;
    std::uint32_t nodes = 0;
  };

  [[nodiscard]] Sample mesh(const Peer& peer, double size) const;
  [[nodiscard]] Sample tetgen(double size) const;
  [[nodiscard]] Size find_size(const Peer& peer, std::uint32_t nodes, double start) const;
  void read_sizes();
  void write_sizes() const;

  std::filesystem::path folder_;
  std::string name_;
  std::string geometry_;  ///< file
  std::size_t faces_ = 0;
  double seconds_ = 0;  ///< of processor time that making the geometry took
  bool sized_;
  double limit_seconds_;
  std::map<std::string, Size> sizes_;  ///< by peer, geometry and nodes asked for
};

/// Whether the programs and packages that a peer needs are there.
bool available(const Peer& peer);

}  // namespace remeshd::bench
