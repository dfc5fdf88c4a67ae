#include "tests/server/fake_engine.h"

#include <cstring>
#include <thread>

#include "engine/base/error.h"
#include "engine/base/random.h"
#include "engine/model/solid.h"
#include "server/service/decode.h"
#include "server/service/encode.h"

namespace remeshd::test {
namespace {

using namespace std::chrono_literals;

/// Numbers and texts one after the other, and back.
class Writer {
 public:
  template <typename T>
  void value(const T& v) {
    bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
  }
  template <typename T>
  void list(const std::vector<T>& values) {
    value(values.size());
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
  }
  template <typename T>
  void list(const CowVector<T>& values) {
    list(values.flat());
  }
  void text(const std::string& s) {
    value(s.size());
    bytes += s;
  }
  std::string bytes;
};

class Reader {
 public:
  explicit Reader(const std::string& bytes) : bytes_(bytes) {}
  template <typename T>
  void value(T& v) {
    take(&v, sizeof v);
  }
  template <typename T>
  void list(std::vector<T>& values) {
    std::size_t size = 0;
    value(size);
    values.resize(size);
    take(values.data(), size * sizeof(T));
  }
  template <typename T>
  void list(CowVector<T>& values) {
    std::vector<T> read;
    list(read);
    values = CowVector<T>(read);
  }
  void text(std::string& s) {
    std::size_t size = 0;
    value(size);
    s.resize(size);
    take(s.data(), size);
  }

 private:
  void take(void* to, std::size_t size) {
    if (at_ + size > bytes_.size()) throw error::internal("serialise", "cut off");
    if (size > 0) std::memcpy(to, bytes_.data() + at_, size);
    at_ += size;
  }
  const std::string& bytes_;
  std::size_t at_ = 0;
};

StoredArrays image_of_fake(const Revision& r) {
  Writer out;
  out.text(encode(r.source).SerializeAsString());
  // Number by number: between them lie bytes that are anything.
  const MeshOptions& o = r.options;
  out.value(o.nodes.value_or(0));
  out.value(o.size.value_or(0));
  out.value(o.iterations);
  out.value(o.seed);
  out.value(o.inside);
  out.value(o.start);
  out.value(o.rebuild);
  out.value(o.clean_up);
  out.value(o.threshold);
  out.value(o.order);
  out.value(o.sizing.even);
  out.value(o.sizing.edges_per_circle);
  out.value(o.sizing.layers);
  out.value(o.sizing.min_size.value_or(0));
  out.value(o.sizing.growth);
  out.value(r.edge_length);
  out.list(r.output.mesh.nodes);
  out.list(r.output.mesh.tets);
  out.list(r.output.node_ids);
  out.list(r.output.tet_ids);
  out.list(r.output.map.node_origin);
  out.list(r.output.map.original_node);
  out.list(r.output.map.node_transform);
  out.list(r.output.map.original_tet);
  out.value(r.report.counts.nodes);
  out.value(r.report.counts.tets);
  out.value(r.report.counts.nodes_kept);
  StoredArray all{.name = "fake"};
  all.own(std::move(out.bytes));
  return {{std::move(all)}};
}

/// The memory of a revision's nodes.
std::vector<MemoryBlock> blocks_of_nodes(const Revision& r) {
  const CowVector<Vec3>& nodes = r.output.mesh.nodes;
  std::vector<MemoryBlock> blocks;
  for (std::size_t k = 0; k < nodes.pages(); ++k)
    blocks.push_back({nodes.page(k).data(), nodes.page_bytes()});
  return blocks;
}

/// Groups and cells, which follow from the model.
void name_parts(Revision& r) {
  MeshGroups& groups = r.output.groups;
  groups.facets = {{{0, 1, 2}, 0, 0}, {{1, 2, 3}, 0, 1}};
  groups.facet_groups = {{r.source.features.front().id + ".top"},
                         {r.source.features.back().id + ".wall", "plate.top"}};
  groups.tet_cell = {r.output.mesh.tets.size(), 0};
  groups.cell_owners = {{}};
  for (const FeatureSource& feature : r.source.features)
    groups.cell_owners[0].push_back(feature.id);
  for (const GroupSource& group : r.source.groups)
    groups.of_model.push_back({.name = group.name, .facets = {1}, .tets = {0}});
  r.output.map.transforms = {Transform{}, Transform::translation({0, 0, 3})};
  r.output.map.transform_features = {"plate", "rib"};
}

/// The rule of the real one without its geometry: a node for each cube of the edge length.
double check_node_limit_fake(const Revision* base, const FeatureModel& model,
                             const MeshOptions& options, const Run& run) {
  double nodes = options.nodes.value_or(0);
  if (!options.nodes) {
    const double edge_length = base != nullptr ? base->edge_length : *options.size;
    for (const Feature& feature : model.features)
      if (feature.nature == Nature::Additive)
        nodes += volume_of(feature.shape) / (edge_length * edge_length * edge_length);
  }
  if (nodes > run.max_nodes)
    throw error::mesh_too_large("this needs", nodes, run.max_nodes, options.nodes ? "nodes" : "",
                                model.features.front().id, "ask for less");
  return nodes;
}

Revision revision_of_fake(const StoredArrays& image) {
  const StoredArray* all = image.find("fake");
  if (all == nullptr) throw error::internal("store", "no array");
  const std::string bytes = all->flat();
  Reader in(bytes);
  Revision r;
  std::string model;
  in.text(model);
  remesh::v1::FeatureModel message;
  if (!message.ParseFromString(model)) throw error::internal("serialise", "no model");
  r.source = decode(message);
  r.model = evaluate(r.source);
  MeshOptions& o = r.options;
  in.value(o.nodes.emplace());
  in.value(o.size.emplace());
  if (*o.nodes == 0) o.nodes.reset();
  if (*o.size == 0) o.size.reset();
  in.value(o.iterations);
  in.value(o.seed);
  in.value(o.inside);
  in.value(o.start);
  in.value(o.rebuild);
  in.value(o.clean_up);
  in.value(o.threshold);
  in.value(o.order);
  in.value(o.sizing.even);
  in.value(o.sizing.edges_per_circle);
  in.value(o.sizing.layers);
  in.value(o.sizing.min_size.emplace());
  if (*o.sizing.min_size == 0) o.sizing.min_size.reset();
  in.value(o.sizing.growth);
  in.value(r.edge_length);
  in.list(r.output.mesh.nodes);
  in.list(r.output.mesh.tets);
  in.list(r.output.node_ids);
  in.list(r.output.tet_ids);
  in.list(r.output.map.node_origin);
  in.list(r.output.map.original_node);
  in.list(r.output.map.node_transform);
  in.list(r.output.map.original_tet);
  in.value(r.report.counts.nodes);
  in.value(r.report.counts.tets);
  in.value(r.report.counts.nodes_kept);
  name_parts(r);
  return r;
}

}  // namespace

struct FakeEngine::State {
  std::mutex mutex;
  std::condition_variable changed;
  bool open = true, wrong = false;
  int started = 0, at_gate = 0, made = 0, stopped = 0, loaded = 0, threads = 0;
  std::filesystem::path dumps;

  template <typename Count>
  void count(Count&& change) {
    const std::scoped_lock lock(mutex);
    change();
    changed.notify_all();
  }
  void pass_gate(const Run& run) {
    std::unique_lock lock(mutex);
    ++at_gate;
    changed.notify_all();
    while (!open) {
      changed.wait_for(lock, 1ms);
      if (run.stop.stop_requested()) break;
    }
    --at_gate;
    changed.notify_all();
  }

  Revision make(const Revision* original, const ModelSource& source, const MeshOptions& options,
                const Run& run) {
    count([&] {
      ++started;
      threads = run.threads;
      dumps = run.dumps;
    });
    Revision r;
    r.source = source;
    r.model = evaluate(source);
    if (std::ranges::any_of(source.parameters, [](const ParameterSource& p) {
          return p.name == "r" && p.value == Scalar(100.0);
        }))
      throw Error({.kind = ErrorKind::FailedPrecondition,
                   .reason = "EMPTY_MODEL",
                   .message = "no cell of the model is positive",
                   .stage = "cells",
                   .hint = "add an additive feature"});
    r.options = options;
    run.report("cells", 0.1);
    pass_gate(run);
    try {
      run.poll();
    } catch (const Error&) {
      count([&] { ++stopped; });
      throw;
    }
    run.report("optimise", 0.5, 1);
    run.report("optimise", 0.7, 2);
    run.report("nodes", 0.2);  // of another attempt

    std::size_t nodes = 100;
    if (options.nodes) {
      nodes = *options.nodes;
    } else if (original != nullptr) {
      nodes = original->output.mesh.nodes.size();
    }
    r.edge_length = original != nullptr ? original->edge_length : options.size.value_or(2.5);
    std::uint64_t mix = options.seed + r.model.features.size() + options.iterations;
    for (const Feature& feature : r.model.features)
      mix = mix * 31 + static_cast<std::uint64_t>(1e6 * (feature.placement.m[3] + 1000));
    for (const ParameterSource& p : source.parameters)
      if (const auto* number = std::get_if<double>(&p.value))
        mix = mix * 31 + static_cast<std::uint64_t>(1e6 * (*number + 1000));
    Random random(wrong ? mix + 1 : mix);
    OutputMesh& d = r.output;
    for (std::size_t i = 0; i < nodes; ++i) {
      d.mesh.nodes.push_back({random.uniform(), random.uniform(), random.uniform()});
      d.node_ids.push_back(1000 + i);
      const bool kept = original != nullptr && i % 2 == 0;
      d.map.node_origin.push_back(kept ? NodeOrigin::Kept : NodeOrigin::New);
      d.map.original_node.push_back(kept ? static_cast<std::int32_t>(i) : -1);
      d.map.node_transform.push_back(kept ? 0 : -1);
      r.report.counts.nodes_kept += kept ? 1 : 0;
    }
    for (std::int32_t i = 0; i + 3 < static_cast<std::int32_t>(nodes); ++i) {
      d.mesh.tets.push_back({i, i + 1, i + 2, i + 3});
      d.tet_ids.push_back(static_cast<std::uint64_t>(i));
      d.map.original_tet.push_back(-1);
    }
    name_parts(r);
    r.report.counts.nodes = static_cast<std::uint32_t>(d.mesh.nodes.size());
    r.report.counts.tets = static_cast<std::uint32_t>(d.mesh.tets.size());
    // A clock's reading, as the real one has it: never twice the same.
    count([&] {
      ++made;
      r.report.seconds.total = 0.001 * made;
    });
    return r;
  }
};

FakeEngine::FakeEngine() : state_(std::make_shared<State>()) {}

Engine FakeEngine::engine() const {
  const auto state = state_;
  return {
      .algorithm_version = 13,
      .evaluate = evaluate,
      .evaluate_edited = evaluate_edited,
      .check_node_limit = check_node_limit_fake,
      .unmeshed = [](const FeatureModel&, const Run&) { return Revision{}; },
      .summarise =
          [](const Revision*, const FeatureModel& model, const MeshOptions&, const Run&) {
            ModelSummary summary;
            summary.volume = 1000.0 * static_cast<double>(model.features.size());
            summary.cells = static_cast<std::uint32_t>(model.features.size());
            return summary;
          },
      .make_revision =
          [state](const Revision* original, const ModelSource& source, const MeshOptions& options,
                  const Run& run) { return state->make(original, source, options, run); },
      .compare =
          [](const FeatureModel& original, const FeatureModel& modified, const CellularModel*,
             const CellularModel*, const Run&) {
            ModelComparison comparison;
            comparison.method = "membership";
            comparison.copycells = static_cast<double>(original.features.size());
            for (const Feature& feature : modified.features)
              comparison.features.push_back({feature.id, {{"++", 1}, {".+", 2}}, {}, {}, {}});
            return comparison;
          },
      .velocities =
          [](const Revision& revision, const std::vector<std::string>& parameters, const Run&) {
            std::vector<NodalVelocities> all;
            for (std::size_t k = 0; k < parameters.size(); ++k) {
              const auto speed = static_cast<double>(k + 1);
              NodalVelocities v{.value = 10 * speed};
              v.velocities.assign(revision.output.mesh.nodes.size(), {speed, 0, -speed});
              v.undefined.assign(v.velocities.size(), 0);
              v.undefined.front() = 1;
              all.push_back(std::move(v));
            }
            return all;
          },
      .gradient =
          [](const Revision&, const std::vector<Vec3>& seed,
             const std::vector<std::string>& parameters, const Run&) {
            double sum = 0;
            for (const Vec3& s : seed) sum += s.x + 10 * s.y + 100 * s.z;
            return std::vector<DesignDerivative>(parameters.size(), {sum, 3});
          },
      .horizon =
          [](const Revision&, const std::string& parameter, double hold, const Run&) {
            return Horizon{7, 7 - hold, 7 + hold, "below " + parameter, "above " + parameter};
          },
      .step_of =
          [](const Revision& revision, const ModelLabels& labels, const Run& run) {
            run.poll();
            return "ISO-10303-21;" + revision.source.name + ";" + labels.unit + ";" + labels.file;
          },
      .image_of = image_of_fake,
      .revision_of =
          [state](const StoredArrays& image, const Revision*, const Run&) {
            state->count([&] { ++state->loaded; });
            return revision_of_fake(image);
          },
      .feature_types = [] { return feature_types(); },
      .memory_blocks = blocks_of_nodes};
}

void FakeEngine::go_wrong() {
  state_->count([&] { state_->wrong = true; });
}
void FakeEngine::close_gate() {
  state_->count([&] { state_->open = false; });
}
void FakeEngine::open_gate() {
  state_->count([&] { state_->open = true; });
}
bool FakeEngine::wait_at_gate(int computations) const {
  std::unique_lock lock(state_->mutex);
  return state_->changed.wait_for(lock, 10s, [&] { return state_->at_gate == computations; });
}
bool FakeEngine::wait_stopped(int computations) const {
  std::unique_lock lock(state_->mutex);
  return state_->changed.wait_for(lock, 10s, [&] { return state_->stopped == computations; });
}
int FakeEngine::made() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->made;
}
int FakeEngine::started() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->started;
}
int FakeEngine::stopped() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->stopped;
}
int FakeEngine::loaded() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->loaded;
}
int FakeEngine::threads() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->threads;
}
std::filesystem::path FakeEngine::dumps() const {
  const std::scoped_lock lock(state_->mutex);
  return state_->dumps;
}

}  // namespace remeshd::test
