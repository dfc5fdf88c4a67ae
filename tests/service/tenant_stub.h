#pragma once

#include <memory>
#include <string>

#include "tests/service/served_daemon.h"

namespace remeshd::test {

/// A stub over a connection of its own, each of whose calls carries a token.
std::unique_ptr<v1::RemeshService::Stub> stub_with(const std::string& token,
                                                   const ServedDaemon& daemon);

}  // namespace remeshd::test
