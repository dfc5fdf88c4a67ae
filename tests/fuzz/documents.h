#pragma once

#include <string>
#include <vector>

#include "engine/model/source.h"
#include "proto/document_error.h"
#include "remesh/v1/remesh.pb.h"
#include "tests/fuzz/finding.h"

namespace remeshd::fuzz {

/// A model with a feature of each type, parameters and expressions, which edits are edits of.
extern const char* const kModelOfEveryType;
/// The same as the engine has it.
const ModelSource& source_of_every_type();

/// A document's error names what is wrong.
inline void expect_in_words(const DocumentError& error) {
  expect(!error.info().reason.empty(), "a document's error without a reason");
  expect(!error.info().message.empty(), "a document's error without a message");
}

/// What holds of every model that a client may send: decoded, written again, evaluated, measured by
/// closed formulas. Throws Error for one that is not right; Finding.
void check_model(const remesh::v1::FeatureModel& message);

/// What holds of every edit that a client may send, of `kModelOfEveryType`. As check_model.
void check_edit(const remesh::v1::ModelEdit& message);

/// The texts of all documents of tests/cases that are models, or edits.
std::vector<std::string> case_documents(bool edits);

}  // namespace remeshd::fuzz
