#include <cstring>
#include <map>
#include <thread>

#include "tests/daemon/timeless.h"
#include "tests/server/daemon_fixture.h"

namespace remeshd::test {
namespace {

using testing::DoubleNear;

class RealEngine : public DaemonTest {
 protected:
  [[nodiscard]] Engine make_engine() const override { return production_engine(); }

  static std::string case_text(const std::string& name) {
    return read_document(std::string(REMESHD_CASES_DIR) + "/" + name + ".json");
  }
  static v1::FeatureModel model(const std::string& name) { return parse_model(case_text(name)); }
  static v1::ModelEdit change(const std::string& name) {
    return parse_edit(case_text(name + ".edit"));
  }
  static v1::CreateRevisionRequest coarse(const std::string& name) {
    auto request = create_request(model(name), 1500);
    request.mutable_options()->set_iterations(5);
    return request;
  }
  std::map<v1::MeshArray, std::string> arrays(const std::string& revision) {
    v1::GetMeshRequest request;
    request.set_revision(revision);
    std::map<v1::MeshArray, std::string> out;
    for (const v1::MeshMessage& message : mesh(request))
      if (message.has_part()) out[message.part().array()] += message.part().data();
    return out;
  }
};

template <typename T>
std::vector<T> values(const std::string& bytes) {
  std::vector<T> out(bytes.size() / sizeof(T));
  std::memcpy(out.data(), bytes.data(), bytes.size());
  return out;
}

struct Case {
  std::string original, edit;
  double volume;  ///< of the modified model, tests/cases/README.md
};
class EveryCase : public RealEngine, public testing::WithParamInterface<Case> {};

TEST_P(EveryCase, IsRemeshedAndItsMapsLeadToTheParentToTheBit) {
  const auto base = create(coarse(GetParam().original));
  const auto child = edit(GetParam().original, change(GetParam().edit));
  EXPECT_NEAR(child.report().exact_volume(), GetParam().volume, 1e-6 * GetParam().volume);
  EXPECT_NEAR(child.report().volume(), GetParam().volume, 0.02 * GetParam().volume);
  EXPECT_GT(child.report().nodes_kept(), 0U);

  auto before = arrays(base.revision().id());
  auto after = arrays(child.revision().id());
  const auto original = values<double>(before[v1::MESH_ARRAY_NODES]);
  const auto nodes = values<double>(after[v1::MESH_ARRAY_NODES]);
  const auto origins = values<std::uint8_t>(after[v1::MESH_ARRAY_NODE_ORIGINS]);
  const auto sources = values<std::int32_t>(after[v1::MESH_ARRAY_ORIGINAL_NODES]);
  const auto by = values<std::int32_t>(after[v1::MESH_ARRAY_NODE_TRANSFORMS]);
  const auto transforms = values<Transform>(after[v1::MESH_ARRAY_TRANSFORMS]);
  const auto ids = values<std::uint64_t>(after[v1::MESH_ARRAY_NODE_IDS]);
  const auto original_ids = values<std::uint64_t>(before[v1::MESH_ARRAY_NODE_IDS]);
  std::uint32_t kept = 0;
  for (std::size_t n = 0; n < origins.size(); ++n) {
    if (origins[n] == 0) continue;
    const auto source = static_cast<std::size_t>(sources[n]);
    EXPECT_EQ(ids[n], original_ids[source]);
    if (origins[n] != 1) continue;
    ++kept;
    const Vec3 there = transforms[static_cast<std::size_t>(by[n])].apply(
        {original[3 * source], original[3 * source + 1], original[3 * source + 2]});
    ASSERT_EQ(there, (Vec3{nodes[3 * n], nodes[3 * n + 1], nodes[3 * n + 2]})) << "node " << n;
  }
  EXPECT_EQ(kept, child.report().nodes_kept());

  const auto tets = values<std::array<std::int32_t, 4>>(after[v1::MESH_ARRAY_TETS]);
  const auto original_tets = values<std::array<std::int32_t, 4>>(before[v1::MESH_ARRAY_TETS]);
  std::uint32_t kept_tets = 0;
  for (std::size_t t = 0;
       const std::int32_t source : values<std::int32_t>(after[v1::MESH_ARRAY_ORIGINAL_TETS])) {
    const auto tet = tets[t++];
    if (source < 0) continue;
    ++kept_tets;
    std::array<std::int32_t, 4> now{}, then = original_tets[static_cast<std::size_t>(source)];
    for (std::size_t k = 0; k < 4; ++k) now[k] = sources[static_cast<std::size_t>(tet[k])];
    std::sort(now.begin(), now.end());
    std::sort(then.begin(), then.end());
    ASSERT_EQ(now, then) << "tet " << t - 1;
  }
  EXPECT_EQ(kept_tets, child.report().tets_kept());
}

INSTANTIATE_TEST_SUITE_P(Paper, EveryCase,
                         testing::Values(Case{"simple-a", "simple-ab", 258000},
                                         Case{"tool1-a", "tool1-ab", 113295.255866},
                                         Case{"tool1-a", "tool1-ac", 109525.344682},
                                         Case{"tool2-a", "tool2-ab", 172863.715790},
                                         Case{"tool2-b", "tool2-bc", 172863.715790},
                                         Case{"tool2-c", "tool2-cd", 172779.646351},
                                         Case{"tool3-a", "tool3-ab", 173327.875959}),
                         [](const auto& test) {
                           std::string name = test.param.edit;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

/// A group's facets lie on chords, and on a seam that crosses facets they cover its faces only
/// about.
TEST_F(RealEngine, AuditsEveryGroupOfFacetsOfTheMesh) {
  for (const char* name : {"tool1-a", "tool2-a", "tool3-a", "fig10-a", "simple-a"}) {
    SCOPED_TRACE(name);
    const v1::Report report = create(coarse(name)).report();
    std::string lines = arrays(name)[v1::MESH_ARRAY_FACET_GROUPS];
    std::replace(lines.begin(), lines.end(), ' ', '+');
    std::string audited;
    std::uint32_t facets = 0;
    double exact = 0, meshed = 0;
    for (const v1::GroupAudit& group : report.groups()) {
      SCOPED_TRACE(group.group());
      audited += group.group() + "\n";
      facets += group.facets();
      meshed += group.mesh_area();
      exact += group.exact_area();
      EXPECT_GT(group.exact_area(), 0);
      EXPECT_EQ(group.centroid_size(), 3);
      EXPECT_EQ(group.normal_size(), 3);
    }
    EXPECT_EQ(audited, lines);
    EXPECT_EQ(facets, report.boundary_facets());
    grpc::ClientContext context;
    v1::ValidateModelRequest request;
    *request.mutable_model() = model(name);
    v1::ValidateModelResponse checked;
    ASSERT_TRUE(stub().ValidateModel(&context, request, &checked).ok());
    EXPECT_NEAR(exact, checked.check().area(), 1e-6 * exact);
    EXPECT_NEAR(meshed, exact, 0.02 * exact);
  }
}

TEST_F(RealEngine, ALoadedBaseGivesTheSameBytesAsTheOneInMemory) {
  use_store();
  create(coarse("tool1-a"));
  const auto first = edit("tool1-a", change("tool1-ac"));
  const auto second = edit("tool1-a", change("tool1-ab"));
  const auto bytes = arrays(second.revision().id());
  const auto base_bytes = arrays("tool1-a@1");
  ASSERT_TRUE(remove(second.revision().id(), true).ok());
  start();
  EXPECT_EQ(arrays("tool1-a@1"), base_bytes);
  const auto again = edit(first.revision().id(), change("tool1-ab"));
  EXPECT_FALSE(again.report().cached());
  EXPECT_EQ(again.revision().id(), second.revision().id());
  EXPECT_EQ(timeless(again.report()).SerializeAsString(),
            timeless(second.report()).SerializeAsString());
  EXPECT_EQ(arrays(again.revision().id()), bytes);
}

TEST_F(RealEngine, CancellingTheCallFreesItsWorkerInEveryStage) {
  start();
  std::vector<std::string> stages{"cells", "nodes", "optimise", "extract", "improve"};
  for (std::size_t i = 0; i < stages.size(); ++i) {
    grpc::ClientContext context;
    const auto stream = stub().EditStream(&context);
    v1::EditStreamRequest request;
    *request.mutable_create() = create_request(model("tool1-a"), 15000);
    request.mutable_create()->mutable_options()->set_seed(i);
    ASSERT_TRUE(stream->Write(request));
    v1::EditStreamResponse reply;
    bool ended = false;
    while (!ended && stream->Read(&reply)) {
      ended = !reply.has_progress();
      if (reply.progress().stage() == stages[i]) break;
    }
    const auto start = std::chrono::steady_clock::now();
    context.TryCancel();
    stream->Finish();
    while (info().load().running() > 0) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::chrono::duration<double, std::milli> spent =
        std::chrono::steady_clock::now() - start;
    RecordProperty("ms_in_" + stages[i], std::to_string(spent.count()));
    EXPECT_FALSE(ended) << stages[i] << " went by unseen";
  }
  EXPECT_EQ(info().load().revisions(), 0U);
}

TEST_F(RealEngine, ValidatesAModelByItsExactVolume) {
  grpc::ClientContext context;
  v1::ValidateModelRequest request;
  *request.mutable_model() = model("tool1-a");
  v1::ValidateModelResponse reply;
  const auto status = stub().ValidateModel(&context, request, &reply);
  ASSERT_TRUE(status.ok()) << status.error_message();
  EXPECT_THAT(reply.check().volume(), DoubleNear(109525.344682, 1e-3));
  EXPECT_GT(reply.check().cells(), 10U);
}

TEST_F(RealEngine, RefusesEmptyAndDisconnectedModelsByName) {
  auto swallowed = plate();
  auto& hole = *swallowed.mutable_features(1);
  hole.set_type("block");
  hole.clear_parameters();
  for (const char* side : {"dx", "dy", "dz"}) parameter(hole, side).set_number_value(200);
  v1::RevisionResult reply;
  EXPECT_EQ(detail(try_create(create_request(swallowed), &reply)).reason(), v1::Error::EMPTY_MODEL);

  auto torn = plate(2, 0);
  auto& island = *torn.add_features();
  island = torn.features(0);
  island.set_id("island");
  island.mutable_placement()->mutable_origin(0)->set_number_value(500);
  EXPECT_EQ(detail(try_create(create_request(torn), &reply)).reason(),
            v1::Error::DISCONNECTED_MODEL);
  EXPECT_TRUE(serves());
}

TEST_F(RealEngine, RefusesAnEditFarTooLargeBeforeAnythingIsComputed) {
  create(create_request(plate(), 1000));
  v1::ModelEdit longer;
  auto& change = *longer.add_edits()->mutable_set_feature_parameter();
  change.set_feature("plate");
  change.set_name("dx");
  change.mutable_value()->set_number_value(1e9);
  v1::RevisionResult made;
  const auto expect_refused = [&](const grpc::Status& status) {
    EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
    EXPECT_EQ(detail(status).reason(), v1::Error::MESH_TOO_LARGE);
    // Only the closed formulas of the features tell which one it is.
    EXPECT_EQ(detail(status).features(0), "plate");
  };
  expect_refused(try_edit(edit_request("plate", longer), &made));
  grpc::ClientContext context;
  v1::ValidateEditRequest request;
  request.set_base("plate");
  *request.mutable_edit() = longer;
  v1::ValidateEditResponse reply;
  expect_refused(stub().ValidateEdit(&context, request, &reply));
  EXPECT_TRUE(serves());
}

TEST_F(RealEngine, ValidatesTheNodesThatAModelNeedsByItsExactVolume) {
  options_.max_nodes = 2000;
  // Blocks in one place: by their volumes alone they might be six times as large.
  auto same = plate();
  for (int k = 0; k < 5; ++k) {
    *same.add_features() = same.features(0);
    same.mutable_features(2 + k)->set_id("again" + std::to_string(k));
  }
  const auto validate = [&](double size) {
    grpc::ClientContext context;
    v1::ValidateModelRequest request;
    *request.mutable_model() = same;
    request.mutable_options()->set_size(size);
    v1::ValidateModelResponse reply;
    return stub().ValidateModel(&context, request, &reply);
  };
  EXPECT_TRUE(validate(4).ok());
  const auto status = validate(2.5);
  EXPECT_EQ(status.error_code(), grpc::StatusCode::INVALID_ARGUMENT);
  EXPECT_EQ(detail(status).reason(), v1::Error::MESH_TOO_LARGE);
}

TEST_F(RealEngine, WorksOnTheControlMeshOfThePaperToo) {
  auto request = coarse("simple-a");
  request.mutable_options()->set_inside(v1::INSIDE_TEST_CONTROL_MESH);
  const auto base = create(request);
  const auto child = edit("simple-a", change("simple-ab"));
  EXPECT_EQ(describe(child.revision().id()).options().inside(), v1::INSIDE_TEST_CONTROL_MESH);
  EXPECT_NE(base.revision().id(), create(coarse("simple-a")).revision().id());
  EXPECT_NEAR(child.report().volume(), child.report().exact_volume(),
              0.02 * child.report().exact_volume());
  EXPECT_GT(child.report().nodes_kept(), base.report().nodes() / 2);
}

TEST_F(RealEngine, SendsTheEdgeLengthsAimedAtOfAMeshThatIsNotEven) {
  auto request = coarse("simple-a");
  request.mutable_options()->mutable_sizing()->set_even(true);
  const auto even = create(request);
  v1::GetMeshRequest sizes_alone;
  sizes_alone.set_revision(even.revision().id());
  sizes_alone.mutable_selection()->add_arrays(v1::MESH_ARRAY_NODE_SIZES);
  const auto messages = mesh(sizes_alone);
  ASSERT_EQ(messages.size(), 2U) << "a header and an end";
  EXPECT_TRUE(messages.front().header().arrays().empty());
  EXPECT_FALSE(arrays(even.revision().id()).contains(v1::MESH_ARRAY_NODE_SIZES));
  auto edited = edit_request("simple-a", change("simple-ab"));
  edited.mutable_options()->mutable_sizing()->set_edges_per_circle(12);
  const auto sized = edit(edited);
  auto of_sized = arrays(sized.revision().id());
  const auto sizes = values<double>(of_sized[v1::MESH_ARRAY_NODE_SIZES]);
  ASSERT_EQ(sizes.size(), sized.report().nodes());
  for (const double size : sizes) {
    EXPECT_GT(size, 0);
    EXPECT_LE(size, 1.0001 * sized.report().edge_length());
  }
}

TEST_F(RealEngine, ForecastsWhatAMeshComesTo) {
  const auto made = create(coarse("tool1-a"));
  grpc::ClientContext context;
  v1::ValidateModelRequest request;
  *request.mutable_model() = model("tool1-a");
  *request.mutable_options() = coarse("tool1-a").options();
  v1::ValidateModelResponse reply;
  ASSERT_TRUE(stub().ValidateModel(&context, request, &reply).ok());
  const v1::MeshForecast& forecast = reply.check().forecast();
  EXPECT_NEAR(forecast.nodes(), made.report().nodes(), 0.05 * made.report().nodes());
  EXPECT_GT(forecast.bytes(), 1'000'000U);
  EXPECT_GT(forecast.seconds(), 0);
  ASSERT_FALSE(forecast.details().empty());
  EXPECT_EQ(forecast.details(0).face().find(forecast.details(0).feature() + "."), 0U);
  EXPECT_LT(forecast.details(0).size(), made.report().edge_length());
}

TEST_F(RealEngine, ComparesAsThePapersFigureElevenShows) {
  grpc::ClientContext context;
  v1::CompareRequest request;
  *request.mutable_original()->mutable_model() = model("fig11-a");
  *request.mutable_modified()->mutable_edit() = change("fig11-ab");
  v1::CompareResponse response;
  const auto status = stub().Compare(&context, request, &response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  const v1::Comparison& reply = response.comparison();
  std::map<std::string, std::map<std::string, double>> cells;
  for (const auto& feature : reply.features())
    cells[feature.id()] = {feature.cells().begin(), feature.cells().end()};
  EXPECT_THAT(cells["base"]["++"], DoubleNear(55686.11, 0.01));
  EXPECT_THAT(cells["base"]["-+"], DoubleNear(2617.43, 0.01));
  EXPECT_THAT(cells["rib"][".+"], DoubleNear(6000, 0.01));
  EXPECT_THAT(reply.newcells(), DoubleNear(2617.43 + 6000, 0.02));
  EXPECT_FALSE(reply.method().empty());
}

TEST_F(RealEngine, ComparesWithMotionsThatAMeshLeavesOut) {
  // A lug flush with the plate; lifted by next to nothing, the plate leaves a step that no tets
  // fit into.
  const v1::FeatureModel flush = parse_model(R"({"name": "lug", "features": [
      {"id": "plate", "nature": "ADDITIVE", "type": "block",
       "parameters": {"dx": 40, "dy": 40, "dz": 20}},
      {"id": "lug", "nature": "ADDITIVE", "type": "block",
       "parameters": {"dx": 30, "dy": 14, "dz": 20}, "placement": {"origin": [20, 0, 0]}}]})");
  const auto base = create(create_request(flush, 600));
  const auto lifted = edit(base.revision().id(), parse_edit(R"({"edits": [
      {"setFeatureParameter": {"feature": "plate", "name": "dz", "value": 20.000004}},
      {"setFeatureParameter": {"feature": "lug", "name": "dx", "value": 40}}]})"));
  grpc::ClientContext context;
  v1::CompareRequest request;
  request.mutable_original()->set_revision(base.revision().id());
  request.mutable_modified()->set_revision(lifted.revision().id());
  v1::CompareResponse response;
  const auto status = stub().Compare(&context, request, &response);
  ASSERT_TRUE(status.ok()) << status.error_message();
  // The exact volume is the document's, with the motion.
  EXPECT_THAT(response.comparison().copycells() + response.comparison().newcells(),
              DoubleNear(lifted.report().exact_volume(), 1e-4));
}

}  // namespace
}  // namespace remeshd::test
