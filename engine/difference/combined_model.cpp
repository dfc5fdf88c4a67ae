#include "engine/difference/combined_model.h"

#include <algorithm>

#include "engine/difference/owned_marks.h"
#include "engine/kernel/brep.h"

namespace remeshd {
namespace {

/// Features of the other model that move by the same transformation: one part of the fuse.
struct Group {
  Transform where;            ///< from the other model to the one whose positions are used
  std::vector<int> features;  ///< indices in the other model
};

/// A feature of the placing model, which is the one whose positions are used.
struct Viewed {
  std::string id;
  int placed = -1;  ///< index in the placing model
  int other = -1;   ///< index in the other model, -1 if not there
  int part = -1;    ///< its part of the fuse, by number, if the other model has it
  OwnedMarks placed_marks, other_marks;
};

/// Puts the feature differences together; `placing`: the model whose positions are used.
class Combiner {
 public:
  Combiner(const ModelView& placing, const ModelView& other, bool placing_is_modified,
           const Run& run)
      : placing_(placing.cells->complex(run)),
        other_(other.cells->complex(run)),
        placing_is_modified_(placing_is_modified) {
    for (int i = 0; i < static_cast<int>(placing.features->features.size()); ++i) {
      const Feature& feature = placing.features->features[i];
      Viewed viewed{feature.id, i, other.features->index_of(feature.id), -1, {}, {}};
      viewed.placed_marks = owned_marks(placing_, {i});
      if (viewed.other >= 0) {
        viewed.other_marks = owned_marks(other_, {viewed.other});
        viewed.part = 1 + group_of(viewed.other,
                                   to_original(feature, other.features->features[viewed.other]));
      }
      viewed_.push_back(std::move(viewed));
    }
  }

  [[nodiscard]] CombinedModel combine(const Run& run) const {
    std::vector<kernel::Part> parts;
    std::vector<int> all(placing_.cells.size());
    for (std::size_t c = 0; c < all.size(); ++c) all[c] = static_cast<int>(c);
    parts.push_back({placing_.brep.get(), all, {}});
    for (const Group& group : groups_)
      parts.push_back(
          {other_.brep.get(), owned_marks(other_, group.features).owned_cells(), group.where});
    const kernel::Fusion fusion = kernel::general_fuse(parts, run);

    CombinedModel out;
    for (std::size_t c = 0; c < fusion.brep.cells.size(); ++c)
      out.cells.push_back(cell(fusion.cells[c], fusion.brep.cells[c].volume));
    for (std::size_t f = 0; f < fusion.brep.faces.size(); ++f)
      out.faces.push_back({fusion.brep.faces[f].cells, views(fusion.faces[f], &OwnedMarks::faces),
                           fusion.brep.faces[f].area});
    for (const CombinedCell& c : out.cells) {
      if (c.copycell) out.copycell_volume += c.volume;
      if (c.newcell) out.newcell_volume += c.volume;
    }
    return out;
  }

 private:
  int group_of(int feature, const Transform& where) {
    auto it = std::ranges::find_if(groups_, [&](const Group& g) { return g.where == where; });
    if (it == groups_.end()) it = groups_.insert(it, Group{where, {}});
    it->features.push_back(feature);
    return static_cast<int>(it - groups_.begin());
  }

  [[nodiscard]] std::vector<PointOfView> views(const std::vector<kernel::Source>& sources,
                                               const std::vector<Mark> OwnedMarks::*kind) const {
    std::vector<PointOfView> out;
    for (const Viewed& viewed : viewed_) {
      Mark placed = Mark::Absent, other = Mark::Absent;
      for (const kernel::Source& source : sources) {
        if (source.part == 0)
          placed = std::min(placed, (viewed.placed_marks.*kind)[source.element]);
        else if (source.part == viewed.part)
          other = std::min(other, (viewed.other_marks.*kind)[source.element]);
      }
      const DifferenceClass value =
          placing_is_modified_ ? classify(other, placed) : classify(placed, other);
      if (value != DifferenceClass::Artefact) out.push_back({viewed.id, value});
    }
    return out;
  }

  [[nodiscard]] CombinedCell cell(const std::vector<kernel::Source>& sources, double volume) const {
    CombinedCell out;
    out.volume = volume;
    out.views = views(sources, &OwnedMarks::cells);
    for (const kernel::Source& source : sources)
      if (source.part == 0) {
        out.owners = placing_.cells[source.element].owners;
        out.positive = placing_.cells[source.element].positive;
      }
    if (placing_is_modified_ && out.positive) {
      out.copycell = std::ranges::any_of(out.views, [](const PointOfView& view) {
        return view.value == DifferenceClass::IdenticalYes;
      });
      out.newcell = !out.copycell;
    }
    return out;
  }

  const CellComplex &placing_, &other_;
  bool placing_is_modified_;
  std::vector<Viewed> viewed_;
  std::vector<Group> groups_;
};

}  // namespace

CombinedModel combined_modified_model(const ModelView& original, const ModelView& modified,
                                      const Run& run) {
  return Combiner(modified, original, true, run).combine(run);
}

CombinedModel combined_original_model(const ModelView& original, const ModelView& modified,
                                      const Run& run) {
  return Combiner(original, modified, false, run).combine(run);
}

}  // namespace remeshd
