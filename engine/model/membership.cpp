#include "engine/model/solid.h"

namespace remeshd {

Membership::Membership(const FeatureModel& model) {
  solids_.reserve(model.features.size());
  for (const Feature& feature : model.features) {
    solids_.emplace_back(feature);
    natures_.push_back(feature.nature);
    if (feature.nature == Nature::Additive) bounds_.add(solids_.back().bounds());
  }
}

int Membership::last_owner(const Vec3& p) const {
  for (std::size_t k = solids_.size(); k-- > 0;)
    if (solids_[k].contains(p)) return static_cast<int>(k);
  return -1;
}

bool Membership::inside(const Vec3& p) const {
  if (!bounds_.contains(p)) return false;
  const int owner = last_owner(p);
  return owner >= 0 && natures_[owner] == Nature::Additive;
}

void Membership::owners(const Vec3& p, std::vector<int>& out) const {
  for (std::size_t k = 0; k < solids_.size(); ++k)
    if (solids_[k].contains(p)) out.push_back(static_cast<int>(k));
}

}  // namespace remeshd
