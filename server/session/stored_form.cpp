#include "server/session/stored_form.h"

#include <cstring>

namespace remeshd {
namespace {

constexpr const char* kEdit = "session.edit";

/// Members in the order in which a record keeps them. None can be added here: attempts follow.
constexpr double PhaseSeconds::*kSeconds[] = {&PhaseSeconds::setup,   &PhaseSeconds::optimise,
                                              &PhaseSeconds::extract, &PhaseSeconds::difference,
                                              &PhaseSeconds::copy,    &PhaseSeconds::verify,
                                              &PhaseSeconds::total};

/// The document that store version 1 kept behind a revision's bytes, its length in four bytes at
/// the very end; the format before it kept none.
std::string older_edit(const std::string& bytes) {
  constexpr std::uint32_t kFirstWithEdit = 9;
  std::uint32_t format = 0, length = 0;
  if (bytes.size() < 1 + sizeof format + sizeof length) return {};
  std::memcpy(&format, bytes.data() + 1, sizeof format);
  if (format < kFirstWithEdit) return {};
  const std::size_t end = bytes.size() - sizeof length;
  std::memcpy(&length, bytes.data() + end, sizeof length);
  return length <= end ? bytes.substr(end - length, length) : std::string();
}

/// Calls `with` for all seconds of a report, in the order in which a record keeps them: those of
/// later versions come last, and older records lack them.
void for_seconds(auto& report, const auto& with) {
  for (const auto member : kSeconds) with(report.seconds.*member);
  for (auto& attempt : report.attempts) with(attempt.seconds);
  with(report.taken.seconds);
  with(report.geometry_seconds);
  for (auto& attempt : report.geometry_attempts) with(attempt.seconds);
}

}  // namespace

std::vector<double> seconds_of(const Report& report) {
  std::vector<double> values;
  for_seconds(report, [&](double seconds) { values.push_back(seconds); });
  return values;
}

void tell_seconds(HeldRevision& held) {
  auto next = held.record.seconds.cbegin();
  for_seconds(held.revision.report, [&](double& seconds) {
    if (next != held.record.seconds.cend()) seconds = *next++;
  });
}

StoredArrays stored_form(const Engine& engine, const HeldRevision& held) {
  StoredArrays arrays = engine.image_of(held.revision);
  if (!held.edit.empty()) arrays.arrays.emplace_back(StoredArray{.name = kEdit}).own(held.edit);
  return arrays;
}

std::shared_ptr<HeldRevision> restored(const Engine& engine, const StoredArrays& arrays,
                                       const RevisionRecord& record, const HeldRevision* alike,
                                       const Run& run) {
  auto held = std::make_shared<HeldRevision>();
  held->record = record;
  held->revision = engine.revision_of(arrays, alike != nullptr ? &alike->revision : nullptr, run);
  Report& report = held->revision.report;
  report.revision = record.id;
  report.cached = false;
  if (const StoredArray* older = arrays.find(kOlderBytes)) {
    held->edit = older_edit(older->flat());
    return held;
  }
  tell_seconds(*held);
  if (const StoredArray* edit = arrays.find(kEdit)) held->edit = edit->flat();
  return held;
}

}  // namespace remeshd
