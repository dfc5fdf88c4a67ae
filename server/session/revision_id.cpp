#include "server/session/revision_id.h"

#include <bit>
#include <string_view>

#include "proto/checksum.h"

namespace remeshd {
namespace {

/// Bytes in which every piece states its length or has a fixed one, so that no two values of a type
/// have the same bytes.
class Canonical {
 public:
  void byte(std::uint8_t value) { bytes_ += static_cast<char>(value); }
  void number(std::uint64_t value) {
    for (unsigned shift = 0; shift < 64; shift += 8)
      byte(static_cast<std::uint8_t>(value >> shift & 255U));
  }
  void real(double value) { number(std::bit_cast<std::uint64_t>(value)); }
  void text(std::string_view value) {
    number(value.size());
    bytes_ += value;
  }
  void scalar(const Scalar& value) {
    byte(static_cast<std::uint8_t>(value.index()));
    if (const auto* literal = std::get_if<double>(&value)) {
      real(*literal);
    } else {
      text(std::get<std::string>(value));
    }
  }
  void triple(const std::array<Scalar, 3>& values) {
    for (const Scalar& value : values) scalar(value);
  }
  void optional_triple(const std::optional<std::array<Scalar, 3>>& values) {
    byte(values ? 1 : 0);
    if (values) triple(*values);
  }
  void scalars(const std::map<std::string, Scalar>& values) {
    number(values.size());
    for (const auto& [name, value] : values) {
      text(name);
      scalar(value);
    }
  }
  void bound(const std::optional<double>& value) {
    byte(value ? 1 : 0);
    real(value.value_or(0));
  }
  void parameter(const ParameterSource& parameter) {
    text(parameter.name);
    scalar(parameter.value);
    bound(parameter.lower);
    bound(parameter.upper);
    byte(parameter.integer ? 1 : 0);
    text(parameter.unit);
  }
  void profile(const std::vector<ProfileEntry>& entries) {
    number(entries.size());
    for (const ProfileEntry& entry : entries) {
      scalar(entry.x);
      scalar(entry.y);
      byte(entry.through ? 1 : 0);
      if (entry.through)
        for (const Scalar& value : *entry.through) scalar(value);
    }
  }
  void feature(const FeatureSource& feature) {
    text(feature.id);
    byte(static_cast<std::uint8_t>(feature.nature));
    text(feature.type);
    scalars(feature.parameters);
    byte(feature.profile ? 1 : 0);
    if (feature.profile) profile(*feature.profile);
    triple(feature.placement.origin);
    optional_triple(feature.placement.z_axis);
    optional_triple(feature.placement.x_axis);
    byte(static_cast<std::uint8_t>(feature.reference.index()));
    if (const auto* kind = std::get_if<ReferenceKind>(&feature.reference)) {
      byte(static_cast<std::uint8_t>(*kind));
    } else {
      triple(std::get<std::array<Scalar, 3>>(feature.reference));
    }
  }
  void model(const ModelSource& source) {
    text(source.name);
    text(source.unit);
    number(source.parameters.size());
    for (const ParameterSource& each : source.parameters) parameter(each);
    number(source.features.size());
    for (const FeatureSource& each : source.features) feature(each);
    if (!source.sizes.empty()) sizes(source.sizes);
    if (!source.groups.empty()) groups(source.groups);
  }
  /// Ids are older than sizes, so a model without them adds no bytes. Sizes begin with the length
  /// of a text, 5; what else may follow a model are options, whose first byte is 0 or 1.
  void sizes(const std::vector<SizeControlSource>& sizes) {
    text("sizes");
    number(sizes.size());
    for (const SizeControlSource& size : sizes) {
      text(size.id);
      byte(static_cast<std::uint8_t>(size.place.index()));
      if (const auto* on = std::get_if<std::string>(&size.place)) {
        text(*on);
      } else if (const auto* ball = std::get_if<BallSource>(&size.place)) {
        for (const Scalar& value : *ball) scalar(value);
      } else {
        for (const Scalar& value : std::get<BoxSource>(size.place)) scalar(value);
      }
      scalar(size.size);
    }
  }
  /// Likewise, a model without groups adds no bytes.
  void groups(const std::vector<GroupSource>& groups) {
    text("groups");
    number(groups.size());
    for (const GroupSource& group : groups) {
      text(group.name);
      text(group.on);
      bound(group.policy.max_area_change);
      byte(group.policy.fail_emptied ? 1 : 0);
    }
  }
  void options(const MeshOptions& options) {
    byte(options.nodes ? 1 : 0);
    number(options.nodes.value_or(0));
    byte(options.size ? 1 : 0);
    real(options.size.value_or(0));
    number(options.iterations);
    number(options.seed);
    byte(static_cast<std::uint8_t>(options.inside));
    byte(static_cast<std::uint8_t>(options.start));
    real(options.threshold);
    byte(options.clean_up ? 1 : 0);
    if (options.order != 1) order(options.order);
    if (options.hold != 0) hold(options.hold);
    if (!options.sizing.even) sizing(options.sizing);
  }
  /// Ids are older than the second order, so the first adds no bytes.
  void order(std::uint32_t order) {
    text("order");
    number(order);
  }
  /// Ids are older than this option, so 0 adds no bytes.
  void hold(double hold) {
    text("hold");
    real(hold);
  }
  /// Ids are older than sizing, so an even mesh adds no bytes. Sizing begins with the length of a
  /// text, 6; what else may follow the options is a parent's id, of length 0 or 64.
  void sizing(const Sizing& sizing) {
    text("sizing");
    number(sizing.edges_per_circle);
    number(sizing.layers);
    bound(sizing.min_size);
    real(sizing.growth);
  }

  [[nodiscard]] const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

}  // namespace

std::string revision_id(const ModelSource& source, const MeshOptions& options,
                        const std::string& parent, std::uint32_t algorithm_version) {
  Canonical canonical;
  canonical.text("remeshd revision");
  canonical.number(algorithm_version);
  canonical.model(source);
  canonical.options(options);
  canonical.text(parent);
  return sha256_hex(canonical.bytes());
}

std::string model_digest(const ModelSource& source) {
  Canonical canonical;
  canonical.text("remeshd model");
  canonical.model(source);
  return sha256_hex(canonical.bytes());
}

}  // namespace remeshd
