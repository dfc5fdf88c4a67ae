#include "engine/boundary/samples.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/base/tolerance.h"
#include "engine/boundary/edge_chains.h"
#include "engine/boundary/lattice.h"
#include "engine/cellular/boundary_model/face_distance.h"

namespace remeshd {

namespace {

// A face with fewer samples is sampled at the centroids of its triangles: instead, or, where
// samples are wanted in some places only, in addition.
constexpr std::size_t kFewSamples = 3;

/// For each face the others on the same surface: a lattice point belongs to the nearest of them.
std::vector<std::vector<int>> rivals(const BoundaryModel& boundary) {
  const double tolerance = 1e-9 * boundary.bounds.diagonal();
  std::vector<std::vector<int>> result(boundary.faces.size());
  for (std::size_t i = 0; i < boundary.faces.size(); ++i)
    for (std::size_t j = 0; j < boundary.faces.size(); ++j)
      if (i != j && boundary.faces[i].surface.kind == boundary.faces[j].surface.kind &&
          boundary.faces[i].reversed == boundary.faces[j].reversed &&
          same_surface(boundary.faces[i].surface, boundary.faces[j].surface, boundary.bounds,
                       tolerance))
        result[i].push_back(static_cast<int>(j));
  return result;
}

/// Where samples are wanted.
class Wanted {
 public:
  explicit Wanted(const std::optional<std::vector<Region>>& places)
      : places_(places ? &*places : nullptr) {
    if (everywhere()) return;
    for (const Region& place : *places_) {
      const std::vector<Box> boxes = place.boxes();
      boxes_.insert(boxes_.end(), boxes.begin(), boxes.end());
    }
  }

  [[nodiscard]] bool everywhere() const { return places_ == nullptr; }
  [[nodiscard]] bool holds(const Vec3& p) const {
    return everywhere() ||
           std::ranges::any_of(*places_, [&](const Region& place) { return place.holds(p); });
  }
  /// Calls f(part, number) for parts of `box` that cover what is wanted in it. They may overlap:
  /// `holds_first` tells the wanted points of each that are in no earlier one.
  template <class F>
  void for_each_part(const Box& box, const F& f) const {
    if (everywhere()) return f(box, 0);
    for (std::size_t k = 0; k < boxes_.size(); ++k)
      if (const Box part = intersection(box, boxes_[k]); !part.empty()) f(part, k);
  }
  [[nodiscard]] bool holds_first(const Vec3& p, std::size_t part) const {
    if (everywhere()) return true;
    return holds(p) && boxes_[part].contains(p) &&
           std::none_of(boxes_.begin(), boxes_.begin() + static_cast<std::ptrdiff_t>(part),
                        [&](const Box& earlier) { return earlier.contains(p); });
  }

 private:
  const std::vector<Region>* places_;  ///< null: everywhere
  std::vector<Box> boxes_;             ///< cover the places
};

void sample_face(const BoundaryModel& boundary, int index, const std::vector<int>& others,
                 const Membership& membership, const SizeField& sizes, const SampleOptions& options,
                 const Wanted& wanted, Random random, const Run& run, std::vector<Sample>& out) {
  const BoundaryFace& face = boundary.faces[index];
  const Support support{Support::Kind::Face, index};
  const double probe = tolerance::kProbe * boundary.bounds.diagonal();
  const Box box = box_of(face.points);
  std::vector<Box> boxes_of_others;
  boxes_of_others.reserve(others.size());
  for (const int other : others) boxes_of_others.push_back(box_of(boundary.faces[other].points));
  const std::size_t begin = out.size();
  const auto relative_area = [&](double length) {
    return (length / sizes.base()) * (length / sizes.base());
  };
  bool reached = false;
  Polling poll(run);
  wanted.for_each_part(box, [&](const Box& part, std::size_t number) {
    reached = true;
    for (const SizeField::EvenPart& even : sizes.even_parts(part, face.surface)) {
      const double spacing = options.face_spacing * even.length;
      const Box within = even.reach(grown(part, spacing));
      visit_lattice(
          face.surface, even.box, within, spacing, options.jitter, random, [&](const Vec3& p) {
            poll();
            if (!box.contains(p, spacing) || !even.holds(p) || !wanted.holds_first(p, number))
              return;
            const Vec3 outward = outward_normal(face, p);
            if (!membership.inside(p - probe * outward) || membership.inside(p + probe * outward))
              return;
            double own = -1;  // not yet computed
            for (std::size_t k = 0; k < others.size(); ++k) {
              if (!boxes_of_others[k].contains(p, spacing)) continue;
              if (own < 0) own = face_distance2(face, p);
              if (face_distance2(boundary.faces[others[k]], p) < own) return;
            }
            out.push_back({p, relative_area(even.length), support});
          });
    }
  });
  if (!reached) return;
  if (out.size() - begin < kFewSamples) {
    if (wanted.everywhere()) out.resize(begin);
    for (const auto& t : face.triangles) {
      const Vec3 centroid = (face.points[t[0]] + face.points[t[1]] + face.points[t[2]]) / 3.0;
      const Vec3 p = project(face.surface, centroid);
      if (wanted.holds(p)) out.push_back({p, relative_area(sizes(p)), support});
    }
  }
  // Weights on a whole face add up to its area; on a part of it each is its spacing squared.
  const double spacing = options.face_spacing * sizes.base();
  double sum = 0;
  for (std::size_t k = begin; k < out.size(); ++k) sum += out[k].weight;
  const double one = wanted.everywhere() ? face.area / sum : spacing * spacing;
  for (std::size_t k = begin; k < out.size(); ++k) out[k].weight *= one;
}

/// The division of an edge into pieces that are equally long in local edge lengths.
class EdgeStations {
 public:
  EdgeStations(const BoundaryEdge& edge, const SizeField& sizes, double spacing)
      : length_(edge.length), chords_(polyline_length(edge)) {
    const SizeField::Range range = sizes.in(box_of(edge.points));
    if (range.least == range.greatest) {
      needed_ = edge.length / (spacing * range.least);
      return;
    }
    double at = 0;
    for (stations_.push_back({0, 0}); at < chords_;) {
      const double length = spacing * sizes(point_at(edge, at));
      const double step = std::fmin(kStep * length, chords_ - at);
      at = step < chords_ - at ? at + step : chords_;
      needed_ += step / length;
      stations_.push_back({at, needed_});
    }
  }

  [[nodiscard]] int count() const { return std::max(3, static_cast<int>(std::ceil(needed_))); }
  /// Length of the polyline up to the end of `k` pieces, of `count()`; k need not be whole.
  [[nodiscard]] double at(double k) const {
    if (stations_.empty()) return chords_ * k / count();
    const double passed = needed_ * k / count();
    const auto after = std::ranges::upper_bound(stations_, passed, {}, &Station::passed);
    if (after == stations_.end()) return chords_;
    const Station &a = *(after - 1), &b = *after;
    return a.at + (b.at - a.at) * (passed - a.passed) / (b.passed - a.passed);
  }
  /// Length of piece `k`.
  [[nodiscard]] double length(int k) const {
    return stations_.empty() ? length_ / count() : length_ * (at(k + 1) - at(k)) / chords_;
  }

 private:
  static constexpr double kStep = 0.5;  // x spacing: between stations
  struct Station {
    double at;      ///< length of the polyline up to it
    double passed;  ///< number of spacings up to it
  };
  double length_, chords_;
  double needed_ = 0;              ///< spacings on the edge
  std::vector<Station> stations_;  ///< none where the field is even along it
};

void sample_edge(const BoundaryModel& boundary, int index, const SizeField& sizes,
                 const SampleOptions& options, const Wanted& wanted, Random random,
                 std::vector<Sample>& out) {
  const BoundaryEdge& edge = boundary.edges[index];
  const EdgeStations stations(edge, sizes, options.edge_spacing);
  const int count = stations.count();
  std::size_t k = 1;
  double passed = 0;  // length of the chords before points[k - 1]
  for (int i = 0; i < count; ++i) {
    const double at = stations.at(i + 0.5 + options.jitter * random.uniform(-0.5, 0.5));
    while (k + 1 < edge.points.size() &&
           passed + distance(edge.points[k - 1], edge.points[k]) < at) {
      passed += distance(edge.points[k - 1], edge.points[k]);
      ++k;
    }
    const double chord = distance(edge.points[k - 1], edge.points[k]);
    const double t = chord > 0 ? (at - passed) / chord : 0;
    const Vec3 p = edge.points[k - 1] + t * (edge.points[k] - edge.points[k - 1]);
    if (wanted.holds(p))
      out.push_back({project(boundary, edge, p), stations.length(i), {Support::Kind::Edge, index}});
  }
}

}  // namespace

std::vector<Vec3> Samples::positions() const {
  std::vector<Vec3> positions;
  positions.reserve(points.size());
  for (const Sample& s : points) positions.push_back(s.position);
  return positions;
}

Samples sample_boundary(const BoundaryModel& boundary, const Membership& membership,
                        const SizeField& sizes, std::uint64_t seed, const SampleOptions& options,
                        const Run& run) {
  Samples samples;
  const std::vector<std::vector<int>> others = rivals(boundary);
  const Wanted wanted(options.where);
  samples.points = collect_in_blocks<Sample>(
      boundary.faces.size(), 1, run,
      [&](std::size_t begin, std::size_t, std::vector<Sample>& found) {
        run.poll();
        const int f = static_cast<int>(begin);
        sample_face(boundary, f, others[f], membership, sizes, options, wanted,
                    Random(seed * 0x9E3779B97F4A7C15ULL + 2 * f), run, found);
      });
  samples.edges_begin = samples.points.size();
  for (int e = 0; e < static_cast<int>(boundary.edges.size()); ++e)
    sample_edge(boundary, e, sizes, options, wanted,
                Random(seed * 0x9E3779B97F4A7C15ULL + 2 * e + 1), samples.points);
  samples.vertices_begin = samples.points.size();
  for (int v = 0; v < static_cast<int>(boundary.vertices.size()); ++v)
    if (const Vec3& p = boundary.vertices[v].position; wanted.holds(p))
      samples.points.push_back({p, 1, {Support::Kind::Vertex, v}});
  return samples;
}

}  // namespace remeshd
