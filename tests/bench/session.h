#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/model/source.h"
#include "tests/bench/peers.h"
#include "tests/bench/results.h"

namespace remeshd::bench {

/// An edit to measure: two model documents.
struct Subject {
  std::string name;
  ModelSource original, modified;
};

/// One of the seven cases by its edit's name, or a detailed part by its own, with its edit.
/// Throws std::runtime_error where there is none of this name.
Subject case_subject(const std::string& name);

/// What is measured of a subject, and how.
struct Settings {
  std::vector<std::uint32_t> iterations{5, 10, 0};  ///< 0: until quality stops improving
  int repeats = 5;                                  ///< rounds
  std::vector<std::uint64_t> seeds{1};              ///< round by round, again from the first
  std::vector<Peer> peers;
  bool paper_regular = false;    ///< regular runs as the paper has them, too
  int chain = 0;                 ///< edits to and fro; 0: none
  bool sized = false;            ///< by the rules, and peers by curvature; not even
  double limit_seconds = 1800;   ///< of a run
  std::filesystem::path folder;  ///< for models, geometries and the peers' sizes
};

/// All runs of a subject at one size, in turn: every round has each of them once, so that what
/// disturbs the machine for a while meets them all. A regular run is asked for the node count of
/// the remesh before it, and so are the peers.
///
/// Throws std::runtime_error where the geometry for the peers is not the model's.
Group measure_group(const Subject& subject, std::uint32_t nodes, const Settings& settings);

}  // namespace remeshd::bench
