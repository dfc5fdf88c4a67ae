#include "engine/mesh/tet_boxes.h"

#include <cmath>

namespace remeshd {
namespace {

constexpr double kCubes = 1.5;  // x cube root of n: cubes along the diagonal of n places' box

Box box_round(const PagedMesh& mesh, std::size_t page) {
  Box box;
  for (const Tet& tet : mesh.tets.page(page)) box.add(box_of(mesh.nodes, tet));
  return box;
}

Region region_round(std::span<const Vec3> places) {
  const double cubes = kCubes * std::cbrt(static_cast<double>(places.size()));
  const double width = places.empty() ? 0 : box_of(places).diagonal() / cubes;
  return {places, width > 0 ? width : 1, 1};
}

}  // namespace

CowVector<Box> boxes_round(const PagedMesh& mesh) {
  CowVector<Box> boxes;
  for (std::size_t k = 0; k < mesh.tets.pages(); ++k) boxes.push_back(box_round(mesh, k));
  return boxes;
}

CowVector<Box> boxes_round(const PagedMesh& mesh, CowVector<Box> other,
                           std::span<const std::int32_t> changed_tets) {
  other.resize(mesh.tets.pages());
  std::size_t done = mesh.tets.pages();
  for (const std::int32_t t : changed_tets) {
    const std::size_t page = static_cast<std::size_t>(t) / mesh.tets.kPage;
    if (page != done) other.edit(page) = box_round(mesh, page);
    done = page;
  }
  return other;
}

PagesNear::PagesNear(const CowVector<Tet>& other, const CowVector<Box>& boxes,
                     std::span<const Vec3> places)
    : other_(other), boxes_(boxes), region_(region_round(places)) {}

bool PagesNear::may_be(const CowVector<Tet>& tets, std::size_t page) const {
  return !tets.shares(page, other_) || region_.meets(boxes_[page]);
}

}  // namespace remeshd
