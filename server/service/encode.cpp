#include "server/service/encode.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

v1::Report::Way encode(Way way) {
  switch (way) {
    case Way::Unchanged:
      return v1::Report::WAY_UNCHANGED;
    case Way::Continued:
      return v1::Report::WAY_CONTINUED;
    case Way::Local:
      return v1::Report::WAY_LOCAL;
    case Way::Full:
      return v1::Report::WAY_FULL;
    case Way::Fresh:
      return v1::Report::WAY_FRESH;
    case Way::TetGen:
      return v1::Report::WAY_TETGEN;
    case Way::Rebased:
      return v1::Report::WAY_REBASED;
  }
  return v1::Report::WAY_UNSPECIFIED;
}
using google::protobuf::Value;

void put(const Scalar& scalar, Value& out) {
  if (const auto* number = std::get_if<double>(&scalar)) {
    out.set_number_value(*number);
  } else {
    out.set_string_value(std::get<std::string>(scalar));
  }
}

template <typename Scalars, typename Add>
void put_all(const Scalars& scalars, Add&& add) {
  for (const Scalar& scalar : scalars) put(scalar, *add());
}

void put_point(const Scalar& x, const Scalar& y, Value& out) {
  auto& values = *out.mutable_list_value();
  put(x, *values.add_values());
  put(y, *values.add_values());
}

void put_profile(const std::vector<ProfileEntry>& profile, Value& out) {
  auto& list = *out.mutable_list_value();
  for (const ProfileEntry& entry : profile) {
    Value& value = *list.add_values();
    if (entry.through) {
      auto& fields = *value.mutable_struct_value()->mutable_fields();
      put_point(entry.x, entry.y, fields["to"]);
      put_point((*entry.through)[0], (*entry.through)[1], fields["through"]);
    } else {
      put_point(entry.x, entry.y, value);
    }
  }
}

void put_feature(const FeatureSource& source, v1::Feature& out) {
  out.set_id(source.id);
  out.set_nature(source.nature == Nature::Additive ? v1::Feature::ADDITIVE
                                                   : v1::Feature::SUBTRACTIVE);
  out.set_type(source.type);
  auto& parameters = *out.mutable_parameters();
  for (const auto& [name, value] : source.parameters) put(value, parameters[name]);
  if (source.profile) put_profile(*source.profile, parameters["profile"]);
  v1::Placement& placement = *out.mutable_placement();
  put_all(source.placement.origin, [&] { return placement.add_origin(); });
  if (source.placement.z_axis)
    put_all(*source.placement.z_axis, [&] { return placement.add_z_axis(); });
  if (source.placement.x_axis)
    put_all(*source.placement.x_axis, [&] { return placement.add_x_axis(); });
  if (const auto* kind = std::get_if<ReferenceKind>(&source.reference)) {
    if (*kind == ReferenceKind::Centre) out.set_reference(v1::Feature::CENTRE);
  } else {
    auto& point = *out.mutable_reference_point();
    put_all(std::get<std::array<Scalar, 3>>(source.reference), [&] { return point.add_values(); });
  }
}

void put_quality(const Quality& quality, v1::Quality& out) {
  out.set_volume_length_mean(quality.volume_length_mean);
  out.set_volume_length_p01(quality.volume_length_p01);
  out.set_volume_length_min(quality.volume_length_min);
  out.set_dihedral_min(quality.dihedral_min);
  out.set_dihedral_max(quality.dihedral_max);
  out.mutable_histogram()->Assign(quality.histogram.begin(), quality.histogram.end());
}

v1::MeshOptions encode_options(const Revision& revision) {
  v1::MeshOptions out;
  const MeshOptions& options = revision.options;
  if (options.nodes) {
    out.set_nodes(*options.nodes);
  } else {
    out.set_size(options.size.value_or(revision.edge_length));
  }
  out.set_iterations(options.iterations);
  out.set_seed(options.seed);
  out.set_clean_up(options.clean_up);
  out.set_inside(options.inside == MeshOptions::Inside::ControlMesh ? v1::INSIDE_TEST_CONTROL_MESH
                                                                    : v1::INSIDE_TEST_MEMBERSHIP);
  out.set_start(options.start == MeshOptions::Start::Random ? v1::START_RANDOM : v1::START_LATTICE);
  out.set_threshold(options.threshold);
  return out;
}

}  // namespace

v1::FeatureModel encode(const ModelSource& source) {
  v1::FeatureModel out;
  out.set_name(source.name);
  out.set_unit(source.unit);
  for (const auto& [name, value] : source.parameters) put(value, (*out.mutable_parameters())[name]);
  for (const FeatureSource& feature : source.features) put_feature(feature, *out.add_features());
  return out;
}

v1::Report encode(const Report& report) {
  v1::Report out;
  const Counts& counts = report.counts;
  out.set_revision(report.revision);
  out.set_cached(report.cached);
  out.set_nodes(counts.nodes);
  out.set_tets(counts.tets);
  out.set_boundary_facets(counts.boundary_facets);
  out.set_volume(report.volume);
  out.set_exact_volume(report.exact_volume);
  out.set_edge_length(report.edge_length);
  out.set_nodes_kept(counts.nodes_kept);
  out.set_tets_kept(counts.tets_kept);
  out.set_nodes_moved(counts.nodes_moved);
  out.set_nodes_copied(counts.nodes_copied);
  out.set_nodes_new(counts.nodes_new);
  out.set_free_share(report.free_share);
  out.set_iterations(counts.iterations);
  out.set_samples(counts.samples);
  out.set_active_samples(counts.active_samples);
  out.set_free_at_start(counts.free_at_start);
  out.set_free_at_end(counts.free_at_end);
  out.mutable_free_per_iteration()->Assign(counts.free_per_iteration.begin(),
                                           counts.free_per_iteration.end());
  v1::Report::Seconds& seconds = *out.mutable_seconds();
  seconds.set_setup(report.seconds.setup);
  seconds.set_optimise(report.seconds.optimise);
  seconds.set_extract(report.seconds.extract);
  seconds.set_difference(report.seconds.difference);
  seconds.set_copy(report.seconds.copy);
  seconds.set_total(report.seconds.total);
  seconds.set_verify(report.seconds.verify);
  v1::Report::Verification& verification = *out.mutable_verification();
  verification.set_tets_proved(report.verification.tets_proved);
  verification.set_tets_inherited(report.verification.tets_inherited);
  verification.set_chord_error(report.verification.chord_error);
  verification.set_volume_error(report.verification.volume_error);
  put_quality(report.quality, *out.mutable_quality());
  put_quality(report.quality_before, *out.mutable_quality_before());
  put_quality(report.quality_away, *out.mutable_quality_away());
  out.set_sharp_tets(report.sharp_tets);
  for (const GroupArea& group : report.groups) {
    v1::GroupArea& area = *out.add_groups();
    area.set_group(group.group);
    area.set_exact_area(group.exact_area);
    area.set_mesh_area(group.mesh_area);
  }
  out.set_way(encode(report.way));
  out.set_nodes_inserted(counts.nodes_inserted);
  for (const std::string& warning : report.warnings) out.add_warnings(warning);
  return out;
}

v1::RevisionInfo encode(const RevisionRecord& record, const PlaceRecord& place) {
  constexpr std::int64_t kNano = 1000000000;
  v1::RevisionInfo out;
  out.set_id(record.id);
  out.set_design(place.design);
  out.set_number(place.number);
  out.set_parent(record.parent);
  out.mutable_created()->set_seconds(record.created_ns / kNano);
  out.mutable_created()->set_nanos(static_cast<std::int32_t>(record.created_ns % kNano));
  out.set_model_name(record.model_name);
  out.set_nodes(record.nodes);
  out.set_tets(record.tets);
  out.set_head(place.head);
  return out;
}

v1::RevisionReply encode(const Made& made, const std::string& request_id) {
  v1::RevisionReply out;
  *out.mutable_revision() = encode(made.filed.record, made.filed.place);
  *out.mutable_report() = encode(made.revision->revision.report);
  out.mutable_report()->set_cached(made.cached);
  out.set_head_moved(made.filed.head_moved);
  out.set_head(made.filed.head);
  out.set_head_number(made.filed.head_number);
  out.set_request_id(request_id);
  return out;
}

v1::RevisionDescription::Place encode(const PlaceRecord& place) {
  v1::RevisionDescription::Place out;
  out.set_design(place.design);
  out.set_number(place.number);
  out.set_head(place.head);
  return out;
}

v1::RevisionDescription encode(const Description& description) {
  v1::RevisionDescription out;
  const Revision& revision = description.revision->revision;
  *out.mutable_revision() = encode(description.record, description.place);
  *out.mutable_model() = encode(revision.source);
  *out.mutable_options() = encode_options(revision);
  *out.mutable_report() = encode(revision.report);
  out.mutable_report()->set_cached(true);
  for (const PlaceRecord& place : description.places) *out.add_places() = encode(place);
  for (const std::string& child : description.children) out.add_children(child);
  return out;
}

v1::DesignInfo encode(const DesignRecord& design) {
  v1::DesignInfo out;
  out.set_name(design.name);
  out.set_head(design.head);
  out.set_head_number(design.head_number);
  out.set_revisions(design.revisions);
  out.set_next_number(design.next_number);
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

v1::ValidateReply encode(const Validated& validated) {
  v1::ValidateReply out;
  *out.mutable_model() = encode(validated.source);
  out.set_volume(validated.summary.volume);
  out.set_area(validated.summary.area);
  out.set_cells(validated.summary.cells);
  out.set_faces(validated.summary.faces);
  out.set_edges(validated.summary.edges);
  out.set_vertices(validated.summary.vertices);
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
