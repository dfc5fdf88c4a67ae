#include <cmath>
#include <limits>
#include <thread>

#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using grpc::StatusCode;
using testing::HasSubstr;

class Errors : public DaemonTest {
 protected:
  /// The Error that a model is refused with; the daemon must serve on.
  v1::Error refused(const v1::FeatureModel& model, StatusCode code = StatusCode::INVALID_ARGUMENT) {
    v1::RevisionResult reply;
    const auto status = try_create(create_request(model), &reply);
    EXPECT_EQ(status.error_code(), code) << status.error_message();
    EXPECT_TRUE(serves());
    return detail(status);
  }
  v1::Error refused_edit(const v1::ModelEdit& changes,
                         StatusCode code = StatusCode::INVALID_ARGUMENT) {
    create(plate());
    v1::RevisionResult reply;
    const auto status = try_edit(edit_request("plate", changes), &reply);
    EXPECT_EQ(status.error_code(), code) << status.error_message();
    EXPECT_TRUE(serves());
    return detail(status);
  }
  static google::protobuf::Value& parameter_of(v1::FeatureModel& model, int feature,
                                               const std::string& name) {
    return parameter(*model.mutable_features(feature), name);
  }
};

TEST_F(Errors, NameFeatureAndParameterAndCarryAHint) {
  auto model = plate();
  parameter_of(model, 1, "radius").set_number_value(-1);
  const auto error = refused(model);
  EXPECT_EQ(error.code(), v1::Error::CODE_INVALID_ARGUMENT);
  EXPECT_EQ(error.features(0), "hole");
  EXPECT_EQ(error.parameter(), "radius");
  EXPECT_EQ(error.reason(), v1::Error::DEGENERATE_FEATURE);
  EXPECT_FALSE(error.message().empty());
  EXPECT_FALSE(error.stage().empty());
}

TEST_F(Errors, ValuesThatNoDocumentCanHoldAreRefusedOnTheWire) {
  for (const double number : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    auto model = plate();
    parameter_of(model, 1, "radius").set_number_value(number);
    const auto error = refused(model);
    EXPECT_EQ(error.reason(), v1::Error::NOT_FINITE);
    EXPECT_EQ(error.features(0), "hole");
    EXPECT_EQ(error.parameter(), "radius");
  }
  auto model = plate();
  parameter_of(model, 1, "radius").set_null_value({});
  EXPECT_THAT(refused(model).message(), HasSubstr("null"));
  parameter_of(model, 1, "radius").set_bool_value(true);
  EXPECT_THAT(refused(model).message(), HasSubstr("true or false"));
  parameter_of(model, 1, "radius").mutable_list_value();
  EXPECT_THAT(refused(model).message(), HasSubstr("a list"));
  parameter_of(model, 1, "radius").clear_kind();
  EXPECT_THAT(refused(model).message(), HasSubstr("nothing"));
  parameter_of(model, 1, "radius").set_string_value(std::string("r\0r", 3));
  EXPECT_THAT(refused(model).message(), HasSubstr("NUL"));

  model = plate();
  model.mutable_features(1)->mutable_placement()->mutable_origin(2)->set_number_value(HUGE_VAL);
  EXPECT_EQ(refused(model).parameter(), "placement.origin[2]");
  model = plate();
  model.mutable_features(1)->mutable_placement()->mutable_origin()->RemoveLast();
  EXPECT_EQ(refused(model).parameter(), "placement.origin");
  model = plate();
  model.mutable_features(1)->set_nature(static_cast<v1::Feature::Nature>(9));
  EXPECT_EQ(refused(model).parameter(), "nature");
  model = plate();
  model.mutable_features(1)->set_reference(static_cast<v1::Feature::Reference>(9));
  EXPECT_EQ(refused(model).parameter(), "reference");
}

TEST_F(Errors, ProfilesAreLookedAtEntryByEntry) {
  auto model = plate();
  auto& prism = *model.add_features();
  prism.set_id("rib");
  prism.set_nature(v1::Feature::ADDITIVE);
  prism.set_type("prism");
  parameter(prism, "height").set_number_value(1);
  auto& profile = parameter(prism, "profile");
  profile.set_number_value(1);
  EXPECT_EQ(refused(model).parameter(), "profile");
  auto& entry = *profile.mutable_list_value()->add_values();
  entry.mutable_list_value()->add_values()->set_number_value(1);
  EXPECT_EQ(refused(model).parameter(), "profile[0]");
  entry.mutable_list_value()->add_values()->set_null_value({});
  EXPECT_EQ(refused(model).parameter(), "profile[0][1]");
  auto& arc = *entry.mutable_struct_value()->mutable_fields();
  arc["to"].mutable_list_value();
  EXPECT_EQ(refused(model).reason(), v1::Error::MISSING_FIELD);
  arc["through"].mutable_list_value();
  arc["radius"].set_number_value(1);
  EXPECT_EQ(refused(model).reason(), v1::Error::UNKNOWN_FIELD);
}

TEST_F(Errors, ListsNestedAHundredThousandDeepOnTheWireAreAnsweredInWords) {
  // protobuf's own classes could neither build nor write this: the bytes are made by hand, from the
  // inside outwards. Value.list_value is field 6, ListValue.values field 1, both by length.
  start();
  const auto wrap = [](int levels) {
    std::vector<std::string> heads;
    std::size_t size = 0;
    const auto head = [&](char tag) {
      std::string bytes(1, tag);
      for (std::size_t rest = size; true; rest >>= 7U) {
        if (rest < 128) {
          bytes += static_cast<char>(rest);
          break;
        }
        bytes += static_cast<char>((rest & 127U) | 128U);
      }
      size += bytes.size();
      heads.push_back(bytes);
    };
    for (int i = 0; i < levels; ++i) {
      head('\x0a');  // ListValue.values
      head('\x32');  // Value.list_value
    }
    std::string all;
    for (auto it = heads.rbegin(); it != heads.rend(); ++it) all += *it;
    return all;
  };
  const auto tagged = [](char tag, const std::string& bytes) {
    std::string out(1, tag);
    for (std::size_t rest = bytes.size(); true; rest >>= 7U) {
      if (rest < 128) {
        out += static_cast<char>(rest);
        break;
      }
      out += static_cast<char>((rest & 127U) | 128U);
    }
    return out + bytes;
  };
  // FeatureModel.parameters is field 3, an entry's value field 2; CreateRevisionRequest.model 1.
  const std::string entry = tagged('\x0a', "deep") + tagged('\x12', wrap(100000));
  const std::string request = tagged('\x0a', tagged('\x1a', entry));
  for (const char* method : {"CreateRevision", "ValidateModel"}) {
    std::string reply;
    const grpc::Status status =
        call(std::string("/remesh.v1.RemeshService/") + method, request, &reply);
    EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT) << status.error_message();
    EXPECT_EQ(detail(status).reason(), v1::Error::MESSAGE_UNREADABLE);
    EXPECT_THAT(status.error_message(), HasSubstr("nested too deep"));
    EXPECT_TRUE(serves());
  }
}

TEST_F(Errors, SixtyListsInsideEachOtherAreAnsweredInWords) {
  auto model = plate();
  auto* value = &parameter_of(model, 1, "radius");
  for (int i = 0; i < 60; ++i) value = value->mutable_list_value()->add_values();
  value->set_number_value(1);
  EXPECT_EQ(refused(model).reason(), v1::Error::MESSAGE_UNREADABLE);
}

TEST_F(Errors, TenMegabytesAreRefusedInWords) {
  auto model = plate();
  std::string& text = *parameter_of(model, 1, "radius").mutable_string_value();
  text.resize(10'000'000, '1');
  const auto error = refused(model);
  EXPECT_EQ(error.reason(), v1::Error::MESSAGE_TOO_LARGE);
  EXPECT_THAT(error.message(), HasSubstr("8388608"));
}

TEST_F(Errors, TwentyMegabytesAreRefusedByGrpc) {
  auto model = plate();
  std::string& text = *parameter_of(model, 1, "radius").mutable_string_value();
  text.resize(20'000'000, '1');
  v1::RevisionResult reply;
  const auto status = try_create(create_request(model), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_THAT(status.error_message(), HasSubstr("16777216"));
  EXPECT_TRUE(serves());
}

TEST_F(Errors, RequestIdsOfMoreThan128BytesAreRefusedAndNotEchoedWhole) {
  auto request = create_request(plate());
  request.set_request_id(std::string(129, 'x'));
  v1::RevisionResult reply;
  auto status = try_create(request, &reply);
  EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(detail(status).reason(), v1::Error::REQUEST_ID_TOO_LONG);
  EXPECT_EQ(detail(status).parameter(), "request_id");
  request.set_request_id(std::string(128, 'x'));
  EXPECT_EQ(create(request).request_id(), request.request_id());

  auto changes = edit_request("plate", set("at", 11));
  changes.set_request_id(std::string(129, 'x'));
  EXPECT_EQ(try_edit(changes, &reply).error_code(), StatusCode::INVALID_ARGUMENT);

  grpc::ClientContext context;
  const auto stream = stub().EditStream(&context);
  v1::EditStreamRequest message;
  *message.mutable_create() = request;
  message.mutable_create()->set_request_id(std::string(1'000'000, 'x'));
  ASSERT_TRUE(stream->Write(message));
  v1::EditStreamResponse answer;
  ASSERT_TRUE(stream->Read(&answer));
  EXPECT_EQ(answer.error().reason(), v1::Error::REQUEST_ID_TOO_LONG);
  EXPECT_EQ(answer.request_id(), std::string(125, 'x') + "...");
  context.TryCancel();
  EXPECT_FALSE(stream->Finish().ok());
}

TEST_F(Errors, AnEditNamesItsIndexAndTheFeatureThatIsNotThere) {
  v1::ModelEdit changes = set("at", 11);
  changes.add_edits()->mutable_remove_feature()->set_feature("knob");
  const auto error = refused_edit(changes, StatusCode::NOT_FOUND);
  EXPECT_TRUE(error.has_edit_index());
  EXPECT_EQ(error.edit_index(), 1U);
  EXPECT_EQ(error.features(0), "knob");

  v1::ModelEdit empty;
  empty.add_edits();
  EXPECT_EQ(refused_edit(empty).edit_index(), 0U);
  v1::ModelEdit nan = set("at", std::nan(""));
  EXPECT_EQ(refused_edit(nan).reason(), v1::Error::NOT_FINITE);
}

TEST_F(Errors, AModelThatIsEmptyAfterTheEditIsRefusedAndNothingIsLeftOfIt) {
  v1::ModelEdit changes;
  changes.add_edits()->mutable_remove_feature()->set_feature("plate");
  refused_edit(changes);
  // The hole takes the whole plate: only the engine can find out.
  const auto error = refused_edit(set("r", 100), StatusCode::FAILED_PRECONDITION);
  EXPECT_EQ(error.reason(), v1::Error::EMPTY_MODEL);
  EXPECT_EQ(error.stage(), "cells");
  EXPECT_EQ(describe("plate").revision().number(), 1U);
  EXPECT_EQ(list().revisions_size(), 1);
}

TEST_F(Errors, OptionsOutOfRangeAreNamed) {
  const auto option = [&](auto&& change) {
    auto request = create_request(plate());
    change(*request.mutable_options());
    v1::RevisionResult reply;
    const auto status = try_create(request, &reply);
    EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
    return detail(status).parameter();
  };
  EXPECT_EQ(option([](auto& o) { o.set_nodes(19); }), "nodes");
  EXPECT_EQ(option([](auto& o) { o.set_nodes(5000001); }), "nodes");
  EXPECT_EQ(option([](auto& o) { o.set_size(0); }), "size");
  EXPECT_EQ(option([](auto& o) { o.set_size(-1); }), "size");
  EXPECT_EQ(option([](auto& o) { o.set_size(std::nan("")); }), "size");
  EXPECT_EQ(option([](auto& o) { o.set_size(HUGE_VAL); }), "size");
  EXPECT_EQ(option([](auto& o) { o.set_iterations(1001); }), "iterations");
  EXPECT_EQ(option([](auto& o) { o.set_inside(static_cast<v1::InsideTest>(7)); }), "inside");
  EXPECT_EQ(option([](auto& o) { o.set_start(static_cast<v1::Start>(7)); }), "start");
  EXPECT_EQ(option([](auto& o) { o.set_threshold(0.9); }), "threshold");
  EXPECT_EQ(option([](auto& o) { o.set_threshold(std::nan("")); }), "threshold");
  EXPECT_EQ(option([](auto& o) { o.set_order(0); }), "order");
  EXPECT_EQ(option([](auto& o) { o.set_order(3); }), "order");
  EXPECT_EQ(option([](auto& o) { o.mutable_sizing()->set_edges_per_circle(2); }),
            "sizing.edges_per_circle");
  EXPECT_EQ(option([](auto& o) { o.mutable_sizing()->set_layers(17); }), "sizing.layers");
  EXPECT_EQ(option([](auto& o) { o.mutable_sizing()->set_min_size(0); }), "sizing.min_size");
  EXPECT_EQ(option([](auto& o) { o.mutable_sizing()->set_growth(1); }), "sizing.growth");
}

TEST_F(Errors, AMeshThatCanNeverFitIsInvalidAndNotToBeTriedAgain) {
  v1::ModelEdit changes;
  auto& change = *changes.add_edits()->mutable_set_feature_parameter();
  change.set_feature("plate");
  change.set_name("dx");
  change.mutable_value()->set_number_value(1e9);
  const auto error = refused_edit(changes);
  EXPECT_EQ(error.reason(), v1::Error::MESH_TOO_LARGE);
  EXPECT_EQ(error.features(0), "plate");
  EXPECT_THAT(error.message(), HasSubstr("5000000"));
  EXPECT_FALSE(error.hint().empty());
  EXPECT_EQ(error.retry_after(), 0);
  EXPECT_EQ(engine_.started(), 1) << "the plate itself";
}

TEST_F(Errors, MissingPartsOfRequestsAreNamed) {
  v1::RevisionResult reply;
  EXPECT_EQ(detail(try_create({}, &reply)).reason(), v1::Error::MISSING_FIELD);
  v1::EditRevisionRequest edit;
  EXPECT_EQ(detail(try_edit(edit, &reply)).reason(), v1::Error::MISSING_FIELD);
  *edit.mutable_edit() = set("at", 1);
  EXPECT_EQ(detail(try_edit(edit, &reply)).parameter(), "base");
}

TEST_F(Errors, ABusyDaemonSaysWhenToTryAgain) {
  options_.workers = 1;
  options_.queue = 1;
  start();
  engine_.close_gate();
  std::vector<std::thread> clients;
  std::vector<v1::RevisionResult> replies(2);
  clients.emplace_back(
      [&] { EXPECT_TRUE(try_create(create_request(plate(1)), &replies[0]).ok()); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  clients.emplace_back(
      [&] { EXPECT_TRUE(try_create(create_request(plate(2)), &replies[1]).ok()); });
  while (info().load().queued() == 0) std::this_thread::yield();
  grpc::ClientContext context;
  v1::CreateRevisionResponse reply;
  const auto status = stub().CreateRevision(&context, create_request(plate(3)), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(detail(status).reason(), v1::Error::BUSY);
  EXPECT_GT(detail(status).retry_after(), 0);
  const auto& trailing = context.GetServerTrailingMetadata();
  const auto pushback = trailing.find("grpc-retry-pushback-ms");
  ASSERT_NE(pushback, trailing.end());
  EXPECT_EQ(std::stod(std::string(pushback->second.data(), pushback->second.size())),
            std::ceil(1000 * detail(status).retry_after()));
  engine_.open_gate();
  for (auto& client : clients) client.join();
}

TEST_F(Errors, WhoWaitsTooLongIsRefused) {
  options_.workers = 1;
  options_.queue_wait = 0.05;
  start();
  engine_.close_gate();
  v1::RevisionResult first, second;
  std::thread client([&] { EXPECT_TRUE(try_create(create_request(plate(1)), &first).ok()); });
  ASSERT_TRUE(engine_.wait_at_gate(1));
  const auto status = try_create(create_request(plate(2)), &second);
  EXPECT_EQ(status.error_code(), StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(detail(status).reason(), v1::Error::WAITED_TOO_LONG);
  engine_.open_gate();
  client.join();
}

TEST_F(Errors, WithoutAStoreFullMemoryRefusesNewRevisionsAndDeletingHelps) {
  options_.cache = 20000;
  create(create_request(plate(1), 1000));
  v1::RevisionResult reply;
  const auto status = try_create(create_request(plate(2), 1000), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::RESOURCE_EXHAUSTED);
  EXPECT_EQ(detail(status).reason(), v1::Error::MEMORY_FULL);
  ASSERT_TRUE(remove("plate", true).ok());
  // The thread that made it may hold it for a moment longer.
  while (try_create(create_request(plate(2), 1000), &reply).error_code() ==
         StatusCode::RESOURCE_EXHAUSTED)
    std::this_thread::yield();
  EXPECT_EQ(reply.revision().number(), 2U);
}

TEST_F(Errors, StayBelowFourKilobytesWhateverTheyQuote) {
  auto model = plate();
  model.mutable_features(1)->set_id(std::string(100000, 'x') + "\xC3\xA4");
  v1::RevisionResult reply;
  const auto status = try_create(create_request(model), &reply);
  EXPECT_EQ(status.error_code(), StatusCode::INVALID_ARGUMENT);
  EXPECT_LT(status.error_details().size(), 4096U);
  EXPECT_LT(status.error_message().size(), 1024U);
}

}  // namespace
}  // namespace remeshd::test
