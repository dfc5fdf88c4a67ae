#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/client/cli/cli_fixture.h"

namespace remeshd::cli {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

class CliInDocuments : public Cli {
 protected:
  std::string write(const std::string& name, const std::string& text) {
    std::ofstream(file(name)) << text;
    return file(name);
  }
  static remesh::v1::Error wrong_value(const std::string& feature, const std::string& parameter) {
    auto error = client::make_error(remesh::v1::Error::CODE_INVALID_ARGUMENT,
                                    remesh::v1::Error::DEGENERATE_FEATURE);
    error.set_stage("model");
    error.add_features(feature);
    error.set_parameter(parameter);
    return error;
  }

  const std::string model_ = R"({"features": [
  {"id": "plate", "nature": "ADDITIVE", "type": "block",
   "parameters": {"dx": 80, "dy": 0, "dz": 10}}]})";
};

TEST_F(CliInDocuments, AValueThatTheDaemonRefusesIsToldWithFileLineAndColumn) {
  const std::string model = write("plate.json", model_);
  service_.stream_errors[0] = wrong_value("plate", "dy");
  EXPECT_EQ(run({"mesh", model, "-o", file("m.vtu")}), kInvalid);
  EXPECT_THAT(err_.str(),
              HasSubstr(model + ":3:35: feature plate, parameter dy: told by the test"));
  service_.failure = wrong_value("plate", "dz");
  EXPECT_EQ(run({"validate", model}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr(model + ":3:44: "));
}

TEST_F(CliInDocuments, OfABaseAndAnEditTheOneAtFaultIsTold) {
  const std::string model = write("plate.json", model_);
  const std::string edit = write("e.json", R"({"edits": [{"setFeatureParameter":
    {"feature": "plate", "name": "dy", "value": -1}}]})");
  service_.stream_errors[0] = wrong_value("plate", "dy");
  EXPECT_EQ(run({"edit", model, edit, "-o", file("m.vtu")}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr(model + ":3:35: "));
  service_.stream_errors.clear();
  service_.stream_errors[1] = wrong_value("plate", "dy");
  EXPECT_EQ(run({"edit", model, edit, "-o", file("m.vtu")}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr(edit + ":2:49: "));
}

TEST_F(CliInDocuments, ADocumentThatCannotBeReadIsToldInTheSameWay) {
  const std::string model = write("plate.json", "{\"features\": [\n  {\"id\": }]}");
  EXPECT_EQ(run({"validate", model}), kInvalid);
  EXPECT_THAT(err_.str(), HasSubstr(model + ":2:10: "));
}

TEST_F(CliInDocuments, WhatIsNotOfTheDocumentHasNoPlaceInIt) {
  const std::string model = write("plate.json", model_);
  auto error = wrong_value("plate", "dy");
  error.set_stage("cells");
  service_.stream_errors[0] = error;
  EXPECT_EQ(run({"mesh", model, "-o", file("m.vtu")}), kInvalid);
  EXPECT_THAT(err_.str(), testing::Not(HasSubstr(model)));
}

}  // namespace
}  // namespace remeshd::cli
