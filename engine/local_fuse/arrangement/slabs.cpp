#include "engine/local_fuse/arrangement/slabs.h"

#include <algorithm>

namespace remeshd {
namespace {

constexpr std::size_t kMaxColumns = 50'000;  // more would take longer than the kernel

}  // namespace

Tried<Slabs> Slabs::find(const Sweeps& sweeps, const PlanarArrangement& arrangement,
                         const Membership& membership, double diagonal) {
  Slabs out;
  for (const Sweep& sweep : sweeps.sweeps) {
    out.z_.push_back(sweep.low);
    out.z_.push_back(sweep.high);
  }
  std::ranges::sort(out.z_);
  std::vector<double> apart;
  for (const double z : out.z_) {
    if (apart.empty() || z - apart.back() >= kClearOutline * diagonal)
      apart.push_back(z);
    else if (z - apart.back() > kSameOutline * diagonal)
      return GaveUp{"slabs", "two heights are neither clearly the same nor clearly apart"};
  }
  out.z_ = std::move(apart);
  if (arrangement.pieces.size() * (out.z_.size() + 1) > kMaxColumns)
    return GaveUp{"slabs", "there are too many slabs beside too many edges of the arrangement"};
  const auto height = [&](double z) {
    return static_cast<int>(std::ranges::upper_bound(out.z_, z) - out.z_.begin()) - 1;
  };
  for (const Sweep& sweep : sweeps.sweeps) {
    out.low_.push_back(height(sweep.low));
    out.high_.push_back(height(sweep.high));
  }
  const auto column = [&](const std::vector<int>& there, int slab) {
    Column c;
    for (const int sweep : there)
      if (out.active(sweep, slab)) c.owners.push_back(sweep);
    c.material = !c.owners.empty() &&
                 membership.nature(sweeps.sweeps[c.owners.back()].feature) == Nature::Additive;
    return c;
  };
  for (const ArrangementEdge& piece : arrangement.pieces)
    for (int slab = 0; slab <= out.heights(); ++slab)
      out.columns_.push_back({column(piece.left, slab), column(piece.right, slab)});
  return out;
}

}  // namespace remeshd
