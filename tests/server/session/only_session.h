#pragma once

#include <memory>
#include <string>
#include <utility>

#include "server/session/tenants.h"

namespace remeshd::test {

/// The session of a daemon that asks for no tokens, over this store. What belongs to it ends with
/// it.
inline std::shared_ptr<Session> only_session(Engine engine, std::unique_ptr<Store> store,
                                             SessionLimits limits = {}, Sharing sharing = {}) {
  const auto given = std::make_shared<std::unique_ptr<Store>>(std::move(store));
  const auto tenants = std::make_shared<Tenants>(
      std::move(engine), std::move(limits),
      [given](const std::string& /*tenant*/) { return std::move(*given); }, nullptr,
      std::move(sharing));
  return {tenants, &tenants->of("")};
}

}  // namespace remeshd::test
