#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "remesh/v1/remesh.pb.h"

namespace CLI {
class App;
}

namespace remeshd::cli {

/// The options of all commands that mesh. What is not given stays unset in the request: the daemon
/// has the defaults, and an edit inherits what its base has.
struct MeshingOptions {
  std::optional<std::uint32_t> nodes;
  std::optional<double> size;
  std::string iterations;  ///< empty, `auto` or a number
  std::optional<std::uint64_t> seed;
  std::uint32_t threads = 1;
  std::string inside;  ///< empty, `membership` or `control-mesh`
  std::string start;   ///< empty, `lattice` or `random`
  std::optional<double> threshold;
  std::optional<std::uint32_t> order;  ///< of the tets: 1 or 2
  std::optional<double> hold;          ///< x edge length
  bool no_clean_up = false;
  bool even = false;
  std::optional<std::uint32_t> edges_per_circle, layers;
  std::optional<double> min_size, growth;
  std::string design;
  bool keep_head = false;
  std::vector<std::string> fail_on;  ///< names of warnings
  bool strict = false;               ///< warnings of losses are errors too

  /// What options are that are not given: defaults of the daemon, or those of an edit's base.
  enum class Unset : std::uint8_t { Default, OfBase };

  void add_to(CLI::App& command, Unset unset = Unset::Default);
  /// Those alone that say what the mesh is like, and which warnings are errors.
  void add_mesh_to(CLI::App& command, Unset unset = Unset::Default);
  [[nodiscard]] remesh::v1::MeshOptions to_message() const;
  /// The warnings of `fail_on` and `strict`, as values of the message's field `fail_on`.
  [[nodiscard]] google::protobuf::RepeatedField<int> warning_codes() const;

  /// Fills everything that both kinds of request have. Without mesh options an edit inherits them;
  /// which warnings are errors is not inherited.
  template <class Request>
  void fill(Request& request, bool with_mesh_options) const {
    if (with_mesh_options) *request.mutable_options() = to_message();
    if (!fail_on.empty() || strict) *request.mutable_options()->mutable_fail_on() = warning_codes();
    request.set_design(design);
    request.set_threads(threads);
    if (keep_head) request.mutable_head()->set_advance(false);
  }

 private:
  void add_sizing_to(CLI::App& command, Unset unset);
};

}  // namespace remeshd::cli
