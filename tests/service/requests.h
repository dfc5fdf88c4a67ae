#pragma once

#include <grpcpp/grpcpp.h>

#include <cstdint>
#include <string>

#include "remesh/v1/remesh.grpc.pb.h"

/// What the programs of this folder ask for.
namespace remeshd::test {

namespace v1 = remesh::v1;

/// The text of a file of tests/cases: `case_text("tool1-a.json")`.
std::string case_text(const std::string& file);

/// A first mesh of tool1-a.
v1::CreateRevisionRequest create_tool1(std::uint32_t nodes);
/// A first mesh of a block whose edges are `size` long.
v1::CreateRevisionRequest create_block(std::uint32_t nodes, double size = 10);
/// An edit that sets a parameter of the model and moves no head.
v1::EditRevisionRequest set_parameter(const std::string& base, const std::string& name,
                                      double value);
/// The `number`th of pin_radius' values, all distinct: any run of them is spread evenly over 3.5 to
/// 4.5, so that two runs cost the same.
double pin_radius(int number);

/// Makes it and returns its revision's id; throws std::runtime_error on an error.
std::string made_by(v1::RemeshService::Stub& stub, const v1::CreateRevisionRequest& request);

/// The reason of a failed call's Error, or `` where it has none; `retry` gets whether its status
/// carries a RetryInfo with a delay.
std::string reason_of(const grpc::Status& status, bool* retry = nullptr);

}  // namespace remeshd::test
