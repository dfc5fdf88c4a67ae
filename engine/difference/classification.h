#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace remeshd {

/// What an element of a feature is in one of the two models. One scale serves both tables: `Yes` is
/// boundary (faces, edges, vertices) or positive (cells), `No` is non-boundary or negative.
enum class Mark : std::uint8_t { Yes, No, Absent };

enum class Relation : std::uint8_t { PersistentIdentical, PersistentDifferent, New, Old };

/// Classes of the feature difference, in the order that reports print.
enum class DifferenceClass : std::uint8_t {
  IdenticalYes,  ///< `++`, `bb`
  ToNo,          ///< `+-`, `bn`
  ToYes,         ///< `-+`, `nb`
  IdenticalNo,   ///< `--`, `nn`
  NewYes,        ///< `.+`, `.b`
  NewNo,         ///< `.-`, `.n`
  OldYes,        ///< `+.`, `b.`
  OldNo,         ///< `-.`, `n.`
  /// No class: of an element that arises only where original geometry crosses modified geometry,
  /// in neither model, or of a point off the feature. In no table; reports leave it out.
  Artefact,
};
inline constexpr std::size_t kDifferenceClasses = 9;

struct Classification {
  Mark original;
  Mark modified;
  DifferenceClass value;
  Relation relation;
  std::string_view cell_name;      ///< as in `diff --json`
  std::string_view geometry_name;  ///< of faces, edges and vertices
  std::string_view words;          ///< of the paper, for faces, edges and vertices
  std::string_view cell_words;     ///< of the paper, for cells
};

/// Tables 1 (faces, edges, vertices) and 2 (cells), row by row.
/// Source: Sypkens Smit & Bronsvoort 2010, Sect. 4.2.
inline constexpr std::array<Classification, 8> kClassifications{{
    {Mark::Yes, Mark::Yes, DifferenceClass::IdenticalYes, Relation::PersistentIdentical, "++", "bb",
     "Persistent-identical: boundary", "Persistent-identical: positive nature"},
    {Mark::No, Mark::No, DifferenceClass::IdenticalNo, Relation::PersistentIdentical, "--", "nn",
     "Persistent-identical: non-boundary", "Persistent-identical: negative nature"},
    {Mark::No, Mark::Yes, DifferenceClass::ToYes, Relation::PersistentDifferent, "-+", "nb",
     "Persistent-different: modified to boundary", "Persistent-different: modified to pos. nature"},
    {Mark::Yes, Mark::No, DifferenceClass::ToNo, Relation::PersistentDifferent, "+-", "bn",
     "Persistent-different: modified to non-boundary",
     "Persistent-different: modified to neg. nature"},
    {Mark::Absent, Mark::Yes, DifferenceClass::NewYes, Relation::New, ".+", ".b", "New: boundary",
     "New: positive nature"},
    {Mark::Absent, Mark::No, DifferenceClass::NewNo, Relation::New, ".-", ".n", "New: non-boundary",
     "New: negative nature"},
    {Mark::Yes, Mark::Absent, DifferenceClass::OldYes, Relation::Old, "+.", "b.", "Old: boundary",
     "Old: positive nature"},
    {Mark::No, Mark::Absent, DifferenceClass::OldNo, Relation::Old, "-.", "n.", "Old: non-boundary",
     "Old: negative nature"},
}};

/// The row for a class; none for Artefact.
constexpr const Classification* find_classification(DifferenceClass value) {
  for (const Classification& row : kClassifications)
    if (row.value == value) return &row;
  return nullptr;
}

constexpr DifferenceClass classify(Mark original, Mark modified) {
  for (const Classification& row : kClassifications)
    if (row.original == original && row.modified == modified) return row.value;
  return DifferenceClass::Artefact;
}

constexpr std::string_view cell_class_name(DifferenceClass value) {
  const Classification* row = find_classification(value);
  return row ? row->cell_name : "artefact";
}

/// Of faces, edges and vertices.
constexpr std::string_view geometry_class_name(DifferenceClass value) {
  const Classification* row = find_classification(value);
  return row ? row->geometry_name : "artefact";
}

/// One number per class: volume, area, length or count.
class ClassTotals {
 public:
  double& operator[](DifferenceClass c) { return totals_[static_cast<std::size_t>(c)]; }
  double operator[](DifferenceClass c) const { return totals_[static_cast<std::size_t>(c)]; }
  friend bool operator==(const ClassTotals&, const ClassTotals&) = default;

 private:
  std::array<double, kDifferenceClasses> totals_{};
};

/// Every class in the order that reports print, Artefact last.
inline constexpr std::array<DifferenceClass, kDifferenceClasses> kAllClasses{
    DifferenceClass::IdenticalYes, DifferenceClass::ToNo,   DifferenceClass::ToYes,
    DifferenceClass::IdenticalNo,  DifferenceClass::NewYes, DifferenceClass::NewNo,
    DifferenceClass::OldYes,       DifferenceClass::OldNo,  DifferenceClass::Artefact};

}  // namespace remeshd
