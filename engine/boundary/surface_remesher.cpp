#include "engine/boundary/surface_remesher.h"

#include <algorithm>
#include <numbers>
#include <queue>
#include <utility>

#include "engine/mesh/grouping.h"

namespace remeshd {
namespace {

/// Lengths of sides are x the length asked for.
struct SurfaceRemeshing {
  double most = 4.0 / 3, least = 4.0 / 5;  ///< longer sides are split, shorter collapsed
  double lengthening = 1.05;               ///< a side too long may grow so much by a collapse
  double upright = 0.64;                   ///< cosine of 50 degrees: a hexagon for a circle passes
  double least_shape = 0.01;               ///< of a facet that a step makes
  double fair_shape = 0.6;                 ///< above this a facet may lose shape when a node moves
  double flip_gain = 1.01;                 ///< of the worse facet's shape
  double growth = 0.5;                     ///< of the length asked for, per distance
};
constexpr SurfaceRemeshing kRemesh;

std::int32_t apex(const Triangle& t, std::int32_t a, std::int32_t b) {
  for (const std::int32_t n : t)
    if (n != a && n != b) return n;
  return -1;
}

}  // namespace

SurfaceRemesher::SurfaceRemesher(SurfaceMesh mesh, const BoundaryModel& boundary, LongestAt longest,
                                 const Run& run)
    : mesh_(std::move(mesh)),
      boundary_(boundary),
      longest_(std::move(longest)),
      run_(run),
      at_(mesh_.nodes.size()) {
  for (std::size_t n = 0; n < mesh_.nodes.size(); ++n)
    lengths_.push_back(longest_(mesh_.supports[n], mesh_.nodes[n]));
  for (std::size_t k = 0; k < mesh_.facets.size(); ++k)
    for (const std::int32_t n : mesh_.facets[k].nodes) at_[n].push_back(static_cast<int>(k));
}

void SurfaceRemesher::grade() {
  using Entry = std::pair<double, std::int32_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  for (std::size_t n = 0; n < lengths_.size(); ++n)
    queue.emplace(lengths_[n], static_cast<std::int32_t>(n));
  while (!queue.empty()) {
    const auto [length, n] = queue.top();
    queue.pop();
    if (length > lengths_[n]) continue;
    for (const std::int32_t k : at_[n])
      for (const std::int32_t m : mesh_.facets[k].nodes) {
        const double most = length + kRemesh.growth * distance(mesh_.nodes[n], mesh_.nodes[m]);
        if (most >= lengths_[m]) continue;
        lengths_[m] = most;
        queue.emplace(most, m);
      }
  }
}

std::int32_t SurfaceRemesher::edge_between(std::int32_t facet, std::int32_t a,
                                           std::int32_t b) const {
  const FaceFacet& f = mesh_.facets[facet];
  for (int i = 0; i < 3; ++i) {
    const std::int32_t p = f.nodes[i], q = f.nodes[(i + 1) % 3];
    if ((p == a && q == b) || (p == b && q == a)) return f.edge[i];
  }
  return -1;
}

std::optional<SurfaceRemesher::Side> SurfaceRemesher::side(std::int32_t a, std::int32_t b) const {
  Side s{a, b, -1, -1, -1, -1, -1};
  for (const std::int32_t k : at_[a]) {
    const Triangle& t = mesh_.facets[k].nodes;
    if (!has_corner(t, b)) continue;
    const bool forward =
        (t[0] == a && t[1] == b) || (t[1] == a && t[2] == b) || (t[2] == a && t[0] == b);
    (forward ? s.left : s.right) = k;
  }
  if (s.left < 0 || s.right < 0) return {};
  s.apex_left = apex(mesh_.facets[s.left].nodes, a, b);
  s.apex_right = apex(mesh_.facets[s.right].nodes, a, b);
  s.edge = edge_between(s.left, a, b);
  return s;
}

double SurfaceRemesher::ratio(std::int32_t a, std::int32_t b) const {
  return 2 * distance(mesh_.nodes[a], mesh_.nodes[b]) / (lengths_[a] + lengths_[b]);
}

/// 1 for an equilateral triangle, 0 for a degenerate one; -1 where it leans off its face by more
/// than 50 degrees, or is upside down on a plane.
double SurfaceRemesher::shape(int face, const Vec3& a, const Vec3& b, const Vec3& c) const {
  const Vec3 n = cross(b - a, c - a);
  const double twice_area = norm(n);
  if (!(twice_area > 0)) return 0;
  const double shape =
      2 * std::numbers::sqrt3 * twice_area / (norm2(b - a) + norm2(c - b) + norm2(a - c));
  const BoundaryFace& f = boundary_.faces[face];
  if (f.surface.kind == Surface::Kind::Plane) return dot(n, outward_normal(f, a)) > 0 ? shape : -1;
  for (const Vec3& p : {(a + b + c) / 3.0, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a)})
    if (dot(n, outward_normal(f, p)) < kRemesh.upright * twice_area) return -1;
  return shape;
}

double SurfaceRemesher::shape_with(const FaceFacet& facet, std::int32_t n, const Vec3& p) const {
  std::array<Vec3, 3> corner;
  for (int i = 0; i < 3; ++i) corner[i] = facet.nodes[i] == n ? p : mesh_.nodes[facet.nodes[i]];
  return shape(facet.face, corner[0], corner[1], corner[2]);
}

bool SurfaceRemesher::joined(std::int32_t a, std::int32_t b) const {
  return std::ranges::any_of(at_[a],
                             [&](std::int32_t k) { return has_corner(mesh_.facets[k].nodes, b); });
}

std::vector<std::int32_t> SurfaceRemesher::neighbours(std::int32_t n) const {
  std::vector<std::int32_t> around;
  for (const std::int32_t k : at_[n])
    for (const std::int32_t m : mesh_.facets[k].nodes)
      if (m != n) around.push_back(m);
  sort_unique(around);
  return around;
}

std::int32_t SurfaceRemesher::add(const FaceFacet& facet) {
  const auto k = static_cast<std::int32_t>(mesh_.facets.size());
  mesh_.facets.push_back(facet);
  for (const std::int32_t n : facet.nodes) at_[n].push_back(k);
  return k;
}

void SurfaceRemesher::remove(std::int32_t facet) {
  for (const std::int32_t n : mesh_.facets[facet].nodes) std::erase(at_[n], facet);
  mesh_.facets[facet].face = -1;
}

std::vector<SurfaceRemesher::Job> SurfaceRemesher::sides_beyond(double limit, bool above) const {
  std::vector<Job> jobs;
  for (const FaceFacet& f : mesh_.facets) {
    if (f.face < 0) continue;
    for (int i = 0; i < 3; ++i) {
      const std::int32_t a = f.nodes[i], b = f.nodes[(i + 1) % 3];
      if (a > b) continue;
      const double r = ratio(a, b);
      if (above ? r > limit : r < limit) jobs.push_back({above ? r : -r, a, b});
    }
  }
  return jobs;
}

void SurfaceRemesher::split_long() { split_long(kRemesh.most); }

void SurfaceRemesher::split_long(double limit) {
  std::priority_queue<Job> jobs({}, sides_beyond(limit, true));
  Polling poll(run_);
  while (!jobs.empty()) {
    poll();
    const Job job = jobs.top();
    jobs.pop();
    const std::optional<Side> s = side(job.a, job.b);
    if (!s || !split(*s)) continue;
    const auto added = static_cast<std::int32_t>(mesh_.nodes.size()) - 1;
    for (const std::int32_t n : neighbours(added))
      if (const double r = ratio(n, added); r > limit) jobs.push({r, n, added});
  }
}

bool SurfaceRemesher::split(const Side& s) {
  const FaceFacet left = mesh_.facets[s.left], right = mesh_.facets[s.right];
  const Support support =
      s.edge >= 0 ? Support{Support::Kind::Edge, s.edge} : Support{Support::Kind::Face, left.face};
  const Vec3 a = mesh_.nodes[s.a], b = mesh_.nodes[s.b];
  const Vec3 p = project(boundary_, support, 0.5 * (a + b));
  if (std::min(norm2(p - a), norm2(p - b)) < 0.04 * norm2(b - a)) return false;
  for (const FaceFacet* f : {&left, &right})
    for (const std::int32_t gone : {s.a, s.b})
      if (shape_with(*f, gone, p) < std::min(kRemesh.least_shape, 0.3 * shape_with(*f, s.a, a)))
        return false;
  const auto m = static_cast<std::int32_t>(mesh_.nodes.size());
  mesh_.nodes.push_back(p);
  mesh_.supports.push_back(support);
  lengths_.push_back(
      std::min({longest_(support, p), lengths_[s.a] + kRemesh.growth * distance(a, p),
                lengths_[s.b] + kRemesh.growth * distance(b, p)}));
  at_.emplace_back();
  const std::int32_t c = s.apex_left, d = s.apex_right;
  const std::int32_t bc = edge_between(s.left, s.b, c), ca = edge_between(s.left, c, s.a);
  const std::int32_t ad = edge_between(s.right, s.a, d), db = edge_between(s.right, d, s.b);
  remove(s.left);
  remove(s.right);
  add({{s.a, m, c}, {s.edge, -1, ca}, left.face});
  add({{m, s.b, c}, {s.edge, bc, -1}, left.face});
  add({{s.b, m, d}, {s.edge, -1, db}, right.face});
  add({{m, s.a, d}, {s.edge, ad, -1}, right.face});
  return true;
}

void SurfaceRemesher::collapse_short() {
  std::vector<Job> jobs = sides_beyond(kRemesh.least, false);
  std::ranges::stable_sort(jobs, [](const Job& x, const Job& y) { return y < x; });
  Polling poll(run_);
  for (const Job& job : jobs) {
    poll();
    const std::optional<Side> s = side(job.a, job.b);
    if (!s || ratio(job.a, job.b) >= kRemesh.least) continue;
    if (may_collapse(*s, s->b, s->a))
      collapse(*s, s->b, s->a);
    else if (may_collapse(*s, s->a, s->b))
      collapse(*s, s->a, s->b);
  }
}

bool SurfaceRemesher::may_collapse(const Side& s, std::int32_t from, std::int32_t to) const {
  const Support::Kind kind = mesh_.supports[from].kind;
  if (kind == Support::Kind::Vertex || (kind == Support::Kind::Edge) != (s.edge >= 0)) return false;
  const std::vector<std::int32_t> at_from = neighbours(from), at_to = neighbours(to);
  std::vector<std::int32_t> common;
  std::ranges::set_intersection(at_from, at_to, std::back_inserter(common));
  if (common.size() != 2) return false;
  // Two model edges would fall together, as an arc and its chord, and the face between be gone.
  for (const auto& [facet, apex] : {std::pair{s.left, s.apex_left}, {s.right, s.apex_right}})
    if (edge_between(facet, from, apex) >= 0 && edge_between(facet, to, apex) >= 0) return false;
  // A tetrahedron would fold into a doubled facet.
  if (at_[from].size() <= 3 && at_[to].size() <= 3) return false;
  double before = 1;
  for (const std::int32_t k : at_[from])
    before = std::min(before, shape_with(mesh_.facets[k], from, mesh_.nodes[from]));
  for (const std::int32_t n : at_from)
    if (n != to && ratio(n, to) > std::max(kRemesh.most, kRemesh.lengthening * ratio(n, from)))
      return false;
  for (const std::int32_t k : at_[from]) {
    if (k == s.left || k == s.right) continue;
    const double after = shape_with(mesh_.facets[k], from, mesh_.nodes[to]);
    if (after < kRemesh.least_shape || (after < 0.3 && after < 0.5 * before)) return false;
  }
  return true;
}

void SurfaceRemesher::collapse(const Side& s, std::int32_t from, std::int32_t to) {
  // Of two sides that fall together at most one is on a model edge, which the new side keeps.
  const std::int32_t at_left =
      std::max(edge_between(s.left, from, s.apex_left), edge_between(s.left, to, s.apex_left));
  const std::int32_t at_right =
      std::max(edge_between(s.right, from, s.apex_right), edge_between(s.right, to, s.apex_right));
  remove(s.left);
  remove(s.right);
  const std::vector<std::int32_t> moving = at_[from];
  at_[from].clear();
  for (const std::int32_t k : moving) {
    std::ranges::replace(mesh_.facets[k].nodes, from, to);
    at_[to].push_back(k);
  }
  for (const std::int32_t k : at_[to]) {
    FaceFacet& f = mesh_.facets[k];
    for (int i = 0; i < 3; ++i) {
      const std::int32_t p = f.nodes[i], q = f.nodes[(i + 1) % 3];
      if (p != to && q != to) continue;
      const std::int32_t other = p == to ? q : p;
      if (other == s.apex_left) f.edge[i] = at_left;
      if (other == s.apex_right) f.edge[i] = at_right;
    }
  }
}

void SurfaceRemesher::flip() {
  std::queue<std::pair<std::int32_t, std::int32_t>> queue;
  for (const FaceFacet& f : mesh_.facets)
    if (f.face >= 0)
      for (int i = 0; i < 3; ++i)
        if (f.nodes[i] < f.nodes[(i + 1) % 3]) queue.emplace(f.nodes[i], f.nodes[(i + 1) % 3]);
  Polling poll(run_);
  while (!queue.empty()) {
    poll();
    const auto [a, b] = queue.front();
    queue.pop();
    const std::optional<Side> s = side(a, b);
    if (!s || !try_flip(*s)) continue;
    for (const auto& [p, q] :
         {std::pair{a, s->apex_left}, {b, s->apex_left}, {a, s->apex_right}, {b, s->apex_right}})
      queue.emplace(p, q);
  }
}

bool SurfaceRemesher::try_flip(const Side& s) {
  if (s.edge >= 0 || s.apex_left == s.apex_right || joined(s.apex_left, s.apex_right)) return false;
  const FaceFacet left = mesh_.facets[s.left];
  const Vec3 &a = mesh_.nodes[s.a], &b = mesh_.nodes[s.b];
  const Vec3 &c = mesh_.nodes[s.apex_left], &d = mesh_.nodes[s.apex_right];
  const double before = std::min(shape(left.face, a, b, c), shape(left.face, b, a, d));
  const double after = std::min(shape(left.face, a, d, c), shape(left.face, d, b, c));
  if (after <= 0 || after < kRemesh.flip_gain * before) return false;
  const std::int32_t bc = edge_between(s.left, s.b, s.apex_left);
  const std::int32_t ca = edge_between(s.left, s.apex_left, s.a);
  const std::int32_t ad = edge_between(s.right, s.a, s.apex_right);
  const std::int32_t db = edge_between(s.right, s.apex_right, s.b);
  remove(s.left);
  remove(s.right);
  add({{s.a, s.apex_right, s.apex_left}, {ad, -1, ca}, left.face});
  add({{s.apex_right, s.b, s.apex_left}, {db, bc, -1}, left.face});
  return true;
}

std::optional<Vec3> SurfaceRemesher::evened_place(std::int32_t n) const {
  const Support& support = mesh_.supports[n];
  if (support.kind == Support::Kind::Vertex) return {};
  Vec3 sum;
  int count = 0;
  for (const std::int32_t m : neighbours(n)) {
    const std::optional<Side> s = side(n, m);
    if (support.kind == Support::Kind::Edge && (!s || s->edge < 0)) continue;
    sum += mesh_.nodes[m];
    ++count;
  }
  if (count < 2) return {};
  return project(boundary_, support, sum / count);
}

void SurfaceRemesher::even_out() {
  Polling poll(run_);
  for (std::int32_t n = 0; n < static_cast<std::int32_t>(mesh_.nodes.size()); ++n) {
    poll();
    if (at_[n].empty()) continue;
    const std::optional<Vec3> place = evened_place(n);
    if (!place) continue;
    double before = 1, after = 1;
    for (const std::int32_t k : at_[n]) {
      before = std::min(before, shape_with(mesh_.facets[k], n, mesh_.nodes[n]));
      after = std::min(after, shape_with(mesh_.facets[k], n, *place));
    }
    if (after >= std::min(before, kRemesh.fair_shape) && after > 0) mesh_.nodes[n] = *place;
  }
}

void SurfaceRemesher::compact() {
  std::vector<std::int32_t> number(mesh_.nodes.size(), -1);
  std::int32_t next = 0;
  for (std::size_t n = 0; n < number.size(); ++n) {
    if (at_[n].empty()) continue;
    mesh_.nodes[next] = mesh_.nodes[n];
    mesh_.supports[next] = mesh_.supports[n];
    lengths_[next] = lengths_[n];
    number[n] = next++;
  }
  mesh_.nodes.resize(next);
  mesh_.supports.resize(next);
  lengths_.resize(next);
  std::erase_if(mesh_.facets, [](const FaceFacet& f) { return f.face < 0; });
  at_.assign(next, {});
  for (std::size_t k = 0; k < mesh_.facets.size(); ++k)
    for (std::int32_t& n : mesh_.facets[k].nodes) {
      n = number[n];
      at_[n].push_back(static_cast<std::int32_t>(k));
    }
}

}  // namespace remeshd
