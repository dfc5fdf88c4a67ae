#include "server/service/remake.h"

#include <algorithm>
#include <mutex>
#include <stop_token>
#include <utility>

#include "proto/document.h"
#include "server/service/decode.h"
#include "server/session/catching.h"
#include "server/session/session_error.h"

namespace remeshd {
namespace {

namespace v1 = remesh::v1;

SizingPatch all_of(const Sizing& sizing) {
  if (sizing.even) return {.even = true};
  return {.even = false,
          .edges_per_circle = sizing.edges_per_circle,
          .layers = sizing.layers,
          .min_size = sizing.min_size,
          .growth = sizing.growth};
}

OptionsPatch all_of(const MeshOptions& options) {
  return {.nodes = options.nodes,
          .size = options.size,
          .iterations = options.iterations,
          .seed = options.seed,
          .inside = options.inside,
          .start = options.start,
          .threshold = options.threshold,
          .clean_up = options.clean_up,
          .order = options.order,
          .hold = options.hold,
          .sizing = all_of(options.sizing)};
}

/// Whether an error says that the mesh of a revision cannot be had any more.
bool is_lost(const Error& failure) {
  const std::string& reason = failure.info().reason;
  return reason == "REVISION_OUTDATED" || reason == "NOT_REPRODUCIBLE" ||
         reason == "STORE_CORRUPTED" || reason == "REVISION_NOT_FOUND";
}

/// What becomes of the head of a design whose head is `now`, where `remade` is made again. An
/// ancestor made again is the base of the last edit, so that `expected` may not be left out.
HeadRule head_rule(HeadRule rule, const std::string& now, const std::string& remade) {
  if (!rule.expected.empty()) {
    rule.advance = rule.advance.value_or(true);
  } else if (rule.advance.value_or(false)) {
    rule.expected = now;
  } else {
    rule.expected = remade;
    rule.advance = !rule.advance && now == remade;
  }
  return rule;
}

/// Goes back from a recipe to the first one whose parent can be had, then carries the recipes out
/// one after the other, each as an edit of the revision before.
class Remaking final : public MakeRequest, public std::enable_shared_from_this<Remaking> {
 public:
  using OnMade = std::function<void(const Made&, const std::vector<std::string>&)>;
  using OnFailed = std::function<void(const Error&)>;

  Remaking(Session& session, Recipe recipe, HeadRule head, std::string design, int threads,
           OnMade made, OnFailed failed)
      : session_(session),
        recipes_{std::move(recipe)},
        head_(std::move(head)),
        design_(std::move(design)),
        threads_(threads),
        made_(std::move(made)),
        failed_(std::move(failed)) {}

  void cancel() override {
    MakeRequestPtr step;
    {
      const std::scoped_lock lock(mutex_);
      cancelled_ = true;
      step = step_;
    }
    stop_.request_stop();
    if (step) step->cancel();
  }

  /// For the lane of preparations.
  void find_base() {
    const auto go_on = [self = shared_from_this()] {
      std::ranges::reverse(self->recipes_);
      self->next();
    };
    const std::string parent = recipes_.back().parent;
    if (parent.empty()) return go_on();
    session_.fetch(parent, stop_.get_token(),
                   {.got = [go_on](const HeldRevisionPtr& /*base*/) { go_on(); },
                    .failed = [self = shared_from_this(),
                               parent](const Error& why) { self->base_failed(parent, why); }});
  }

 private:
  void base_failed(const std::string& parent, const Error& why) {
    if (!is_lost(why)) return fail(why);
    // Queued as work of its own: this may be a thread that must not be kept, and recursion along a
    // long chain of ancestors would overflow the stack.
    catching(
        [&] {
          session_.later(
              Lane::Preparation,
              {.run =
                   [self = shared_from_this(), parent] {
                     catching(
                         [&] {
                           self->recipes_.push_back(self->session_.recipe_of_ancestor(parent));
                           self->find_base();
                         },
                         [&](const Error& failure) { self->fail(failure); });
                   },
               .refused = [self =
                               shared_from_this()](const Error& failure) { self->fail(failure); }});
        },
        [&](const Error& failure) { fail(failure); });
  }

  void next() {
    const std::size_t at = at_;
    const Recipe& recipe = recipes_.at(at);
    const bool last = at + 1 == recipes_.size();
    const HeadRule head =
        last ? head_ : HeadRule{.advance = false, .never = true, .file = head_.file};
    Listener listener{.progress = {},
                      .made = [self = shared_from_this()](const Made& made) { self->take(made); },
                      .failed = [self = shared_from_this()](const Error& why) { self->fail(why); }};
    MakeRequestPtr step;
    if (recipe.parent.empty()) {
      step = session_.make(CreateCommand{.source = recipe.model,
                                         .options = all_of(recipe.options),
                                         .design = design_,
                                         .head = head,
                                         .threads = threads_},
                           std::move(listener));
    } else {
      step = session_.make(
          EditCommand{.base = at == 0 ? recipe.parent : base_,
                      .edit = decode(parse_edit(recipe.edit, {.bytes = recipe.edit.size()})),
                      .document = recipe.edit,
                      .options = all_of(recipe.options),
                      .design = design_,
                      .head = head,
                      .threads = threads_},
          std::move(listener));
    }
    bool cancelled = false;
    {
      const std::scoped_lock lock(mutex_);
      if (ended_ || at_ != at) return;  // it has its answer already
      step_ = step;
      cancelled = cancelled_;
    }
    if (cancelled) step->cancel();
  }

  void take(const Made& made) {
    if (at_ + 1 == recipes_.size()) {
      end();
      return made_(made, ancestors_);
    }
    base_ = made.filed.record.id;
    ancestors_.push_back(base_);
    {
      const std::scoped_lock lock(mutex_);
      ++at_;
    }
    catching([&] { next(); }, [&](const Error& why) { fail(why); });
  }
  void fail(const Error& why) {
    end();
    failed_(why);
  }
  /// Lets go of the last step, which holds this.
  void end() {
    MakeRequestPtr step;  // ends after the lock
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    step.swap(step_);
  }

  Session& session_;
  std::vector<Recipe> recipes_;  ///< once the base is found, the furthest ancestor's first
  const HeadRule head_;
  const std::string design_;
  const int threads_;
  const OnMade made_;
  const OnFailed failed_;
  std::size_t at_ = 0;
  std::string base_;
  std::vector<std::string> ancestors_;
  std::stop_source stop_;  ///< of the search for the base
  std::mutex mutex_;
  bool cancelled_ = false, ended_ = false;
  MakeRequestPtr step_;
};

}  // namespace

MakeRequestPtr remake(Session& session, const v1::RemakeRevisionRequest& request,
                      std::function<void(const Made&, const std::vector<std::string>&)> made,
                      std::function<void(const Error&)> failed) {
  const Reference reference = session.resolve(request.revision());
  HeadRule head = decode(request.head());
  std::string design = request.design();
  if (head.file.value_or(true)) {
    if (design.empty()) design = reference.design;
    if (design.empty()) design = session.design_of(reference.id);
    if (design.empty()) head.file = false;
  }
  if (!design.empty()) head = head_rule(std::move(head), session.head_of(design), reference.id);
  const auto remaking = std::make_shared<Remaking>(
      session, session.recipe(reference.id), std::move(head), std::move(design),
      std::max<int>(1, static_cast<int>(request.threads())), std::move(made), std::move(failed));
  remaking->find_base();
  return remaking;
}

}  // namespace remeshd
