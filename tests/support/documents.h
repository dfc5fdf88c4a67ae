#pragma once

#include <nlohmann/json_fwd.hpp>

#include "engine/model/source.h"

namespace remeshd::test {

/// Model and edit documents as values and back. These readers take well-formed documents as they
/// are and check nothing: documents of clients go through the protocol.
ModelSource read_model(const nlohmann::json& document);
ModelEdit read_edit(const nlohmann::json& document);

/// Numbers come back to the same bits; what has its default is left out.
nlohmann::json write_model(const ModelSource& model);
nlohmann::json write_edit(const ModelEdit& edit);

}  // namespace remeshd::test
