#include "engine/cellular/crossed_edges.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace remeshd {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kStraight = 1e-9;  // rad

/// Whether the same lies round two points of a curve.
bool alike(const std::vector<Sheet>& a, const std::vector<Sheet>& b) {
  const std::size_t n = a.size();
  if (b.size() != n) return false;
  // An ellipse's sheets turn in its frame.
  for (std::size_t shift = 0; shift < n; ++shift) {
    bool same = true;
    for (std::size_t i = 0; same && i < n; ++i) {
      const Sheet &p = a[i], &q = b[(i + shift) % n];
      same = p.before == q.before && p.behind == q.behind && p.covers == q.covers;
    }
    if (same) return true;
  }
  return n == 0;
}

/// Whether all there is is one face that goes on.
bool passes(const std::vector<Sheet>& sheets) {
  return sheets.size() == 2 && sheets[0].covers == sheets[1].covers &&
         sheets[0].before == sheets[1].behind &&
         norm(sheets[0].direction + sheets[1].direction) < kStraight;
}

class Finder {
 public:
  Finder(const std::vector<Carrier>& carriers, const Wedges& wedges, const Clearance& clearance)
      : carriers_(carriers), wedges_(wedges), same_(clearance.same), clear_(clearance.clear) {}

  std::optional<CrossedEdges> find() {
    for (int c = 0; c < static_cast<int>(carriers_.size()); ++c) {
      add_parts(c);
      if (doubt_) return std::nullopt;
    }
    join_parts();
    return std::move(out_);
  }

 private:
  int node(const Vec3& p) {
    // Along a direction in which few nodes lie at the same place.
    const double key = 0.5377 * p.x + 0.6113 * p.y + 0.5806 * p.z;
    for (auto it = by_key_.lower_bound(key - clear_);
         it != by_key_.end() && it->first <= key + clear_; ++it) {
      const double d = distance(out_.nodes[it->second], p);
      if (d <= same_) return it->second;
      if (d < clear_) doubt_ = true;
    }
    out_.nodes.push_back(p);
    seam_.push_back(0);
    by_key_.emplace(key, static_cast<int>(out_.nodes.size()) - 1);
    return static_cast<int>(out_.nodes.size()) - 1;
  }

  /// The splits of a carrier in order, each place once; a closed one's first again at the end.
  [[nodiscard]] std::vector<Carrier::Split> splits_of(const Carrier& carrier) const {
    std::vector<Carrier::Split> all = carrier.splits, out;
    if (carrier.round)
      for (Carrier::Split& split : all) {
        split.t = std::fmod(split.t, kTurn);
        if (split.t < 0) split.t += kTurn;
      }
    std::ranges::sort(all, {}, &Carrier::Split::t);
    for (const Carrier::Split& split : all) {
      if (!out.empty() && distance(carrier.at(out.back().t).p, carrier.at(split.t).p) <= same_)
        out.back().seam = out.back().seam || split.seam;
      else
        out.push_back(split);
    }
    if (!carrier.round || out.empty()) return out;
    if (out.size() > 1 &&
        distance(carrier.at(out.back().t).p, carrier.at(out.front().t).p) <= same_) {
      out.front().seam = out.front().seam || out.back().seam;
      out.pop_back();
    }
    out.push_back({out.front().t + kTurn, out.front().seam});
    return out;
  }

  void add_parts(int c) {
    const Carrier& carrier = carriers_[c];
    const std::vector<Carrier::Split> splits = splits_of(carrier);
    for (std::size_t i = 0; i + 1 < splits.size(); ++i) {
      const double from = splits[i].t, to = splits[i + 1].t, middle = 0.5 * (from + to);
      auto sheets = wedges_.around(carrier, middle);
      if (!sheets) {
        doubt_ = true;
        return;
      }
      if (sheets->empty() || (passes(*sheets) && !is_seam(carrier, *sheets))) continue;
      if ((to - from) * norm(carrier.at(middle).derivative) < clear_) doubt_ = true;
      const int a = node(carrier.at(from).p), b = node(carrier.at(to).p);
      if (splits[i].seam) seam_[a] = 1;
      if (splits[i + 1].seam) seam_[b] = 1;
      out_.edges.push_back({c, from, to, a, b, middle, *std::move(sheets)});
    }
  }

  static bool is_seam(const Carrier& carrier, const std::vector<Sheet>& sheets) {
    return std::ranges::any_of(sheets.front().covers, [&](const Patch* cover) {
      return std::ranges::any_of(carrier.seams, [&](const Patch* seam) { return seam == cover; });
    });
  }

  /// Makes one edge of two where nothing else ends between them.
  void join_parts() {
    std::vector<std::vector<int>> ends(out_.nodes.size());
    for (int e = 0; e < static_cast<int>(out_.edges.size()); ++e)
      for (const int n : {out_.edges[e].a, out_.edges[e].b}) ends[n].push_back(e);
    std::vector<char> gone(out_.edges.size(), 0);
    for (int n = 0; n < static_cast<int>(ends.size()); ++n) {
      if (seam_[n] != 0 || ends[n].size() != 2 || ends[n][0] == ends[n][1]) continue;
      int first = ends[n][0], second = ends[n][1];
      if (out_.edges[first].b != n) std::swap(first, second);
      CrossedEdge &a = out_.edges[first], &b = out_.edges[second];
      if (a.carrier != b.carrier || a.b != n || b.a != n || !alike(a.sheets, b.sheets)) continue;
      const double length = b.to - b.from;
      a.to += length;
      a.b = b.b;
      std::ranges::replace(ends[b.b], second, first);
      gone[second] = 1;
    }
    std::vector<CrossedEdge> kept;
    for (std::size_t e = 0; e < gone.size(); ++e)
      if (!gone[e]) kept.push_back(std::move(out_.edges[e]));
    out_.edges = std::move(kept);
  }

  const std::vector<Carrier>& carriers_;
  const Wedges& wedges_;
  double same_, clear_;
  bool doubt_ = false;
  std::multimap<double, int> by_key_;  ///< nodes
  std::vector<char> seam_;             ///< by node
  CrossedEdges out_;
};

}  // namespace

std::optional<CrossedEdges> find_crossed_edges(const std::vector<Carrier>& carriers,
                                               const Wedges& wedges, const Clearance& clearance) {
  return Finder(carriers, wedges, clearance).find();
}

}  // namespace remeshd
