#include "server/tier/breaker.h"

#include <type_traits>
#include <utility>

#include "server/limits.h"
#include "server/tier/tier_error.h"

namespace remeshd {
namespace {

// One failure may be that of a single connection.
constexpr int kFailures = 3;

}  // namespace

Breaker::Breaker(std::unique_ptr<ObjectStore> store, std::function<void(const std::string&)> tell,
                 std::function<Clock::time_point()> now)
    : store_(std::move(store)), tell_(std::move(tell)), now_(std::move(now)) {}

void Breaker::begin(Haste haste) {
  const std::scoped_lock lock(mutex_);
  if (failures_ < kFailures) return;
  const auto now = now_();
  if (now < closed_from_)
    throw error::tier_unavailable(why_, std::chrono::duration<double>(closed_from_ - now).count());
  // This call tries the store. Others fail meanwhile, unless it may end before the store answers.
  if (haste == Haste::None) closed_from_ = now + limits::kTierRest;
}

void Breaker::note_success() {
  const std::scoped_lock lock(mutex_);
  if (std::exchange(failures_, 0) >= kFailures && tell_) tell_("");
}

void Breaker::note_failure(const std::string& why) {
  const std::scoped_lock lock(mutex_);
  if (++failures_ < kFailures) return;
  closed_from_ = now_() + limits::kTierRest;
  why_ = why;
  if (failures_ == kFailures && tell_) tell_(why);
}

template <typename Work>
auto Breaker::tried(Work&& work, Haste haste) {
  begin(haste);
  try {
    if constexpr (std::is_void_v<decltype(work())>) {
      work();
      note_success();
    } else {
      auto result = work();
      note_success();
      return result;
    }
  } catch (const TierTimeout& failure) {
    if (haste == Haste::None) note_failure(failure.info().message);
    throw;
  } catch (const Error& failure) {
    if (failure.info().reason == "TIER_REFUSED") {
      note_success();  // the store answers
    } else if (failure.info().kind != ErrorKind::Cancelled) {
      note_failure(failure.info().message);
    }
    throw;
  }
}

bool Breaker::has(const std::string& key, double within) {
  const Haste haste = within < limits::kTierAnswer ? Haste::Great : Haste::None;
  return tried([&] { return store_->has(key, within); }, haste);
}

std::optional<std::string> Breaker::get(const std::string& key, const std::stop_token& stop) {
  return tried([&] { return store_->get(key, stop); });
}

void Breaker::put(const std::string& key, const std::string& bytes) {
  tried([&] { store_->put(key, bytes); });
}

std::optional<std::string> Breaker::start_of(const std::string& key, std::size_t bytes) {
  return tried([&] { return store_->start_of(key, bytes); });
}

void Breaker::list(const std::string& prefix, const std::function<void(const ObjectInfo&)>& visit) {
  tried([&] { store_->list(prefix, visit); });
}

void Breaker::remove(const std::string& key) {
  tried([&] { store_->remove(key); });
}

}  // namespace remeshd
