#include "server/guard/doorman.h"

#include <utility>

#include "engine/base/error.h"

namespace remeshd {
namespace {

Error unauthenticated(std::string reason, std::string message) {
  ErrorInfo info;
  info.kind = ErrorKind::Unauthenticated;
  info.reason = std::move(reason);
  info.message = std::move(message);
  info.stage = "request";
  info.hint = "send the metadata `authorization: Bearer TOKEN`; of `remesh`: --token-file FILE";
  return Error(std::move(info));
}

/// The scheme's name may be written in any case (RFC 7235).
bool is_bearer(std::string_view authorization) {
  constexpr std::string_view kScheme = "bearer ";
  if (authorization.size() < kScheme.size()) return false;
  for (std::size_t i = 0; i < kScheme.size(); ++i) {
    const char c = authorization[i];
    if ((c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) != kScheme[i]) return false;
  }
  return true;
}

}  // namespace

Doorman::Doorman(std::filesystem::path token_file)
    : file_(std::move(token_file)), tokens_(Tokens::read(file_)) {}

void Doorman::prepare_with(Prepare prepare) {
  const std::scoped_lock reloading(reloading_);
  if (prepare)
    for (const std::string& tenant : tokens_.tenants()) prepare(tenant);
  prepare_ = std::move(prepare);
}

void Doorman::reload() {
  const std::scoped_lock reloading(reloading_);
  Tokens fresh = Tokens::read(file_);
  if (prepare_)
    for (const std::string& tenant : fresh.tenants()) prepare_(tenant);
  const std::scoped_lock lock(mutex_);
  tokens_ = std::move(fresh);
}

std::string Doorman::tenant_of(const std::optional<std::string_view>& authorization) const {
  if (!authorization)
    throw unauthenticated("CREDENTIALS_MISSING",
                          "the call has no token, and this daemon asks for one");
  if (!is_bearer(*authorization))
    throw unauthenticated("CREDENTIALS_INVALID", "the authorization is no bearer token");
  const std::scoped_lock lock(mutex_);
  if (auto tenant = tokens_.tenant_of(authorization->substr(7))) return *tenant;
  throw unauthenticated("CREDENTIALS_INVALID", "the token is not known");
}

void Doorman::check_again(const std::optional<std::string_view>& authorization,
                          const std::string& tenant) const {
  if (tenant_of(authorization) != tenant)
    throw unauthenticated("CREDENTIALS_INVALID", "the token has become another tenant's");
}

}  // namespace remeshd
