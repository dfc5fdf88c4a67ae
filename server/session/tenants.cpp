#include "server/session/tenants.h"

#include <utility>

#include "server/admission/load_error.h"

namespace remeshd {

Tenants::Tenants(Engine engine, SessionLimits limits, OpenStore open_store,
                 std::shared_ptr<Metrics> metrics, Sharing sharing)
    : open_store_(std::move(open_store)),
      sharing_(std::move(sharing)),
      resources_(std::move(engine), std::move(limits), std::move(metrics)) {
  open("");
}

Tenants::~Tenants() { stop(); }

void Tenants::open(const std::string& tenant) {
  const std::scoped_lock opening(opening_);
  {
    const std::scoped_lock lock(mutex_);
    if (stopped_) throw error::shutting_down();
    if (sessions_.contains(tenant)) return;
  }
  auto session = std::make_unique<Session>(resources_, tenant, open_store_(tenant), sharing_);
  session->on_store_health([this, tenant](bool healthy) { note_health(tenant, healthy); });
  const std::scoped_lock lock(mutex_);
  if (stopped_) throw error::shutting_down();
  sessions_.emplace(tenant, std::move(session));
}

Session& Tenants::of(const std::string& tenant) {
  const std::scoped_lock lock(mutex_);
  return *sessions_.at(tenant);
}

std::vector<Session*> Tenants::sessions() {
  const std::scoped_lock lock(mutex_);
  std::vector<Session*> all;
  for (const auto& [tenant, session] : sessions_) all.push_back(session.get());
  return all;
}

Load Tenants::load() {
  Load sum;
  for (Session* const session : sessions()) {
    const Load load = session->load();
    sum.running = load.running;  // of the lane that they share
    sum.queued = load.queued;
    sum.waiting += load.waiting;
    sum.held += load.held;
    sum.held_bytes += load.held_bytes;
    sum.revisions += load.revisions;
    sum.designs += load.designs;
    sum.disk_bytes += load.disk_bytes;
    sum.tier_waiting += load.tier_waiting;
  }
  sum.memory_bytes = sum.held_bytes + resources_.memory().leased();
  return sum;
}

void Tenants::on_store_health(HealthListener listener) {
  const std::scoped_lock lock(health_);
  health_listener_ = std::move(listener);
  if (health_listener_) health_listener_(unhealthy_);
}

void Tenants::note_health(const std::string& tenant, bool healthy) {
  const std::scoped_lock lock(health_);
  const bool changed = healthy ? unhealthy_.erase(tenant) > 0 : unhealthy_.insert(tenant).second;
  if (changed && health_listener_) health_listener_(unhealthy_);
}

void Tenants::stop() {
  {
    const std::scoped_lock lock(mutex_);
    stopped_ = true;
  }
  for (Session* const session : sessions()) session->stop();
  resources_.stop();
}

}  // namespace remeshd
