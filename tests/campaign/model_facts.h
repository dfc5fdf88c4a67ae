#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "engine/model/source.h"
#include "tests/campaign/measure.h"
#include "tests/campaign/topology.h"

namespace remeshd::campaign {

/// What is known about a model before it is meshed.
struct ModelFacts {
  std::string refused;  ///< reason of the Error that the document or its cells raise; else empty
  double volume = 0, area = 0;
  Measure measure;  ///< this and the rest where nothing was refused, else contacts only
  Topology topology;
};

/// `length`: the target edge length; 0: that for `nodes`.
ModelFacts find_facts(const ModelSource& model, double length, double nodes);

/// Whether the model cannot be meshed because of what it is, and the client is told so: its
/// document is not valid, or it is no single manifold body. What the CAD kernel fails at is not
/// among them.
bool rightly_refused(const ModelFacts& facts);

}  // namespace remeshd::campaign
