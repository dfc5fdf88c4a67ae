#pragma once

#include <cstdint>
#include <string>

#include "engine/remesh/remesh.h"

namespace remeshd {

/// The name of a revision: SHA-256, in hexadecimal digits, over the model as written (expressions,
/// order of features, references and placements; parameters of the model in their order with bounds
/// and units but without descriptions, those of features sorted by name; sizes and groups in their
/// order; numbers as the bytes of their IEEE doubles), the options but `rebuild`, which no request
/// sets, the parent's id and the algorithm's version.
///
/// Two requests with the same id give the same mesh. A radius of "r" with r = 4 and a radius of 4
/// have different ids: they are different documents to edit.
std::string revision_id(const ModelSource& source, const MeshOptions& options,
                        const std::string& parent, std::uint32_t algorithm_version);

/// SHA-256, in hexadecimal digits, over what a revision's id has of the model.
std::string model_digest(const ModelSource& source);

}  // namespace remeshd
