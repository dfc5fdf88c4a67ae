#include "server/service/encode.h"

#include "proto/document.h"
#include "proto/json_writer.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

/// No rule of the size field holds for an even mesh, so none is told.
void put(const Sizing& sizing, v1::Sizing& out) {
  out.set_even(sizing.even);
  if (sizing.even) return;
  out.set_edges_per_circle(sizing.edges_per_circle);
  out.set_layers(sizing.layers);
  if (sizing.min_size) out.set_min_size(*sizing.min_size);
  out.set_growth(sizing.growth);
}

v1::MeshOptions encode_options(const Revision& revision) {
  MeshOptions options = revision.options;
  if (!options.nodes && !options.size) options.size = revision.edge_length;
  return encode(options);
}

}  // namespace

void put_time(std::int64_t ns, google::protobuf::Timestamp& out) {
  constexpr std::int64_t kNano = 1000000000;
  out.set_seconds(ns / kNano);
  out.set_nanos(static_cast<std::int32_t>(ns % kNano));
}

v1::MeshOptions encode(const MeshOptions& options) {
  v1::MeshOptions out;
  if (options.nodes) out.set_nodes(*options.nodes);
  if (options.size) out.set_size(*options.size);
  out.set_iterations(options.iterations);
  out.set_seed(options.seed);
  out.set_clean_up(options.clean_up);
  out.set_inside(options.inside == MeshOptions::Inside::ControlMesh ? v1::INSIDE_TEST_CONTROL_MESH
                                                                    : v1::INSIDE_TEST_MEMBERSHIP);
  out.set_start(options.start == MeshOptions::Start::Random ? v1::START_RANDOM : v1::START_LATTICE);
  out.set_threshold(options.threshold);
  out.set_order(options.order);
  out.set_hold(options.hold);
  put(options.sizing, *out.mutable_sizing());
  return out;
}

std::string in_one_line(const MeshOptions& options) {
  std::string line;
  // No value of the options has a line break of its own.
  for (const char c : write_json(encode(options), {.write_zeros = false})) {
    if (c == '\n') continue;
    const bool indents = c == ' ' && (line.ends_with(' ') || line.ends_with('{'));
    if (!indents) line += c;
    if (c == ',') line += ' ';
  }
  return line;
}

v1::RevisionInfo encode(const RevisionRecord& record, const PlaceRecord& place) {
  v1::RevisionInfo out;
  out.set_id(record.id);
  out.set_design(place.design);
  out.set_number(place.number);
  out.set_parent(record.parent);
  out.set_root(record.root);
  put_time(record.created_ns, *out.mutable_created());
  out.set_model_name(record.model_name);
  out.set_nodes(record.nodes);
  out.set_tets(record.tets);
  out.set_mid_nodes(record.mid_nodes);
  out.set_algorithm_version(record.algorithm_version);
  out.set_head(place.head);
  return out;
}

v1::RevisionResult encode(const Made& made, const std::string& request_id) {
  v1::RevisionResult out;
  *out.mutable_revision() = encode(made.filed.record, made.filed.place);
  v1::Report& report = *out.mutable_report();
  report = encode_report(*made.revision);
  report.set_cached(made.cached);
  for (const Warning& warning : made.warnings) *report.add_warnings() = encode(warning);
  out.set_durable(made.filed.durable);
  out.set_head_conflict(made.filed.head_conflict);
  out.set_head(made.filed.head);
  out.set_head_number(made.filed.head_number);
  out.set_request_id(request_id);
  return out;
}

v1::DesignPlace encode(const PlaceRecord& place) {
  v1::DesignPlace out;
  out.set_design(place.design);
  out.set_number(place.number);
  out.set_head(place.head);
  return out;
}

v1::GetRevisionResponse encode(const Description& description, bool documents) {
  v1::GetRevisionResponse out;
  const HeldRevisionPtr& held = description.revision;
  const std::string& edit = held ? held->edit : description.recipe->edit;
  *out.mutable_revision() = encode(description.record, description.place);
  *out.mutable_model() = encode(held ? held->revision.source : description.recipe->model);
  if (!edit.empty()) *out.mutable_edit() = parse_edit(edit, {.bytes = edit.size()});
  if (held) {
    *out.mutable_options() = encode_options(held->revision);
    *out.mutable_report() = encode_report(*held);
    out.mutable_report()->set_cached(true);
  } else {
    *out.mutable_options() = encode(description.recipe->options);
  }
  for (const PlaceRecord& place : description.places) *out.add_places() = encode(place);
  for (const std::string& child : description.children) out.add_children(child);
  out.set_durable(description.durable);
  if (documents) {
    out.set_model_document(write_document(out.model()));
    out.set_edit_document(edit);
  }
  return out;
}

v1::DesignInfo encode(const DesignRecord& design) {
  v1::DesignInfo out;
  out.set_name(design.name);
  out.set_head(design.head);
  out.set_head_number(design.head_number);
  out.set_revisions(design.revisions);
  out.set_next_number(design.next_number);
  if (design.changed_ns > 0) put_time(design.changed_ns, *out.mutable_changed());
  return out;
}

v1::Comparison encode(const ModelComparison& comparison) {
  v1::Comparison out;
  for (const FeatureComparison& feature : comparison.features) {
    v1::Comparison::Feature& message = *out.add_features();
    message.set_id(feature.id);
    message.mutable_cells()->insert(feature.cells.begin(), feature.cells.end());
    message.mutable_faces()->insert(feature.faces.begin(), feature.faces.end());
    message.mutable_edges()->insert(feature.edges.begin(), feature.edges.end());
    message.mutable_vertices()->insert(feature.vertices.begin(), feature.vertices.end());
  }
  out.set_copycells(comparison.copycells);
  out.set_newcells(comparison.newcells);
  out.set_method(comparison.method);
  out.set_error_bound(comparison.error_bound);
  out.set_remark(comparison.remark);
  return out;
}

v1::ModelCheck encode(const Validated& validated) {
  v1::ModelCheck out;
  *out.mutable_model() = encode(validated.source);
  out.set_volume(validated.summary.volume);
  out.set_area(validated.summary.area);
  out.set_cells(validated.summary.cells);
  out.set_faces(validated.summary.faces);
  out.set_edges(validated.summary.edges);
  out.set_vertices(validated.summary.vertices);
  for (const Warning& warning : validated.summary.warnings) *out.add_warnings() = encode(warning);
  const Forecast& forecast = validated.summary.forecast;
  v1::MeshForecast& expected = *out.mutable_forecast();
  expected.set_nodes(forecast.nodes);
  expected.set_bytes(forecast.bytes);
  expected.set_seconds(forecast.seconds);
  for (const Forecast::Detail& detail : forecast.details) {
    v1::MeshForecast::Detail& entry = *expected.add_details();
    entry.set_feature(detail.feature);
    entry.set_face(detail.feature + "." + detail.face);
    entry.set_size(detail.size);
  }
  return out;
}

v1::FeatureType encode(const FeatureTypeInfo& type) {
  v1::FeatureType out;
  out.set_name(type.name);
  out.set_description(type.description);
  for (const ParameterInfo& info : type.parameters) {
    v1::FeatureType::Parameter& parameter = *out.add_parameters();
    parameter.set_name(info.name);
    parameter.set_unit(info.unit);
    parameter.set_description(info.description);
    parameter.set_required(info.required);
    parameter.set_default_value(info.default_value);
  }
  for (const std::string& face : type.faces) out.add_faces(face);
  return out;
}

v1::Progress encode(const Progress& progress) {
  v1::Progress out;
  out.set_stage(std::string(progress.stage));
  out.set_iteration(static_cast<std::uint32_t>(progress.iteration));
  out.set_fraction(progress.fraction);
  return out;
}

}  // namespace remeshd
