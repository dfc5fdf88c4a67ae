#pragma once

#include <grpcpp/create_channel.h>
#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "client/library/farm.h"
#include "proto/rendezvous.h"
#include "remeshd/client.h"
#include "tests/client/fake_daemon.h"

namespace remeshd::client {

inline const grpc::Status kReset(grpc::StatusCode::INTERNAL,
                                 "Received RST_STREAM with error code 2");
inline const std::string kId(64, 'a');

inline remesh::v1::Error elsewhere(const std::string& home) {
  remesh::v1::Error error =
      make_error(remesh::v1::Error::CODE_FAILED_PRECONDITION, remesh::v1::Error::DESIGN_ELSEWHERE);
  error.set_home(home);
  return error;
}

inline remesh::v1::Error starting(double retry_after) {
  remesh::v1::Error error =
      make_error(remesh::v1::Error::CODE_UNAVAILABLE, remesh::v1::Error::STARTING);
  error.set_retry_after(retry_after);
  return error;
}

inline remesh::v1::Error error_told_by(const std::function<void()>& call) {
  try {
    call();
  } catch (const CallError& e) {
    return e.detail();
  }
  return {};
}

/// Nothing is sent to them.
inline std::shared_ptr<Farm> farm_of(const std::vector<std::string>& addresses) {
  std::vector<std::unique_ptr<Replica>> replicas;
  for (const std::string& address : addresses)
    replicas.push_back(std::make_unique<Replica>(
        address, grpc::CreateChannel(address, grpc::InsecureChannelCredentials()), ""));
  return std::make_shared<Farm>(std::move(replicas));
}

/// Three daemons, named in the order in which they are asked for the design `plate`.
class Lists : public testing::Test {
 protected:
  Lists() {
    const auto ranked = rank_by_rendezvous(
        {daemons_[0].address, daemons_[1].address, daemons_[2].address}, "plate");
    for (std::size_t k = 0; k < 3; ++k) ranked_[k] = &daemons_[ranked[k]];
  }
  [[nodiscard]] Client connect() const {
    return Client::connect_any({daemons_[0].address, daemons_[1].address, daemons_[2].address});
  }
  [[nodiscard]] FakeService& first() const { return ranked_[0]->service; }
  [[nodiscard]] FakeService& second() const { return ranked_[1]->service; }
  [[nodiscard]] FakeService& third() const { return ranked_[2]->service; }
  [[nodiscard]] std::vector<std::size_t> calls() const {
    return {first().keys.size(), second().keys.size(), third().keys.size()};
  }
  [[nodiscard]] std::vector<std::size_t> streamed() const {
    return {first().requests.size(), second().requests.size(), third().requests.size()};
  }
  static remesh::v1::EditRevisionRequest edit(const std::string& base = "plate@1") {
    remesh::v1::EditRevisionRequest request;
    request.set_base(base);
    return request;
  }

  std::array<FakeDaemon, 3> daemons_;
  std::array<FakeDaemon*, 3> ranked_{};
};

}  // namespace remeshd::client
