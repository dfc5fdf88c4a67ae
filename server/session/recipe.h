#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/remesh/remesh.h"
#include "server/session/held_revision.h"
#include "server/session/mesh_arrays.h"

namespace remeshd {

/// What a mesh can be made again of, and the digests that it then must have.
struct Recipe {
  struct Digest {
    ArrayName array;
    std::string digest;  ///< as `ArrayDigest::whole`
    friend bool operator==(const Digest&, const Digest&) = default;
  };
  std::string revision;  ///< id
  std::string parent;    ///< id; empty for a first mesh
  std::uint32_t algorithm_version = 0;
  ModelSource model;            ///< after the edit
  std::string edit;             ///< its document; empty for a first mesh
  MeshOptions options;          ///< as `make_revision` takes them
  std::vector<Digest> digests;  ///< of the arrays that are delivered
  friend bool operator==(const Recipe&, const Recipe&) = default;
};

/// Digests of the arrays of a revision that are delivered. `alike`: as of `recipe_of`.
std::vector<Recipe::Digest> digests_of(const HeldRevision& held,
                                       const HeldRevision* alike = nullptr);

/// The recipe of a revision whose `asked` is set; else an empty one. `alike`: a revision that has
/// blocks of arrays in common with it, whose digests are taken over; null for none.
Recipe recipe_of(const HeldRevision& held, const HeldRevision* alike = nullptr);

/// The text of a recipe as it is kept: JSON, the same for equal recipes.
std::string write_recipe(const Recipe& recipe);
/// Throws Error(Internal) on anything else.
Recipe read_recipe(const std::string& text);

}  // namespace remeshd
