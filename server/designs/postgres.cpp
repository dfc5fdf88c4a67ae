#include "server/designs/postgres.h"

#include <libpq-fe.h>
#include <poll.h>

#include <memory>
#include <utility>

#include "server/designs/design_error.h"

namespace remeshd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kMostConnections = 4;
constexpr std::chrono::seconds kToConnect(2), kToAnswer(3), kToBeFree(3);
// How long a database that failed, or did not answer, is not asked again.
constexpr std::chrono::milliseconds kRest(500), kRestAfterSilence(3000);

const std::string kSilent = "it does not answer";

struct Clear {
  void operator()(PGresult* result) const { PQclear(result); }
};
using Result = std::unique_ptr<PGresult, Clear>;

/// The first line of what libpq tells.
std::string first_line(const char* text) {
  const std::string all(text);
  return all.substr(0, all.find('\n'));
}

/// Waits until the socket can be read or written; false after the deadline.
bool wait_for(PGconn* connection, short events, Clock::time_point deadline) {
  for (;;) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    if (left <= 0) return false;
    pollfd socket{.fd = PQsocket(connection), .events = events, .revents = 0};
    const int ready = ::poll(&socket, 1, static_cast<int>(left));
    if (ready > 0) return true;
  }
}

/// Finishes connecting, within `kToConnect`. Returns why that failed; empty for success.
std::string finish_connecting(PGconn* connection) {
  const auto deadline = Clock::now() + kToConnect;
  for (auto next = PGRES_POLLING_WRITING; next != PGRES_POLLING_OK;
       next = PQconnectPoll(connection)) {
    if (next == PGRES_POLLING_FAILED) return first_line(PQerrorMessage(connection));
    const short events = next == PGRES_POLLING_READING ? POLLIN : POLLOUT;
    if (!wait_for(connection, events, deadline)) return kSilent;
  }
  return {};
}

/// Appends the rows of the answer to what was sent. Returns why that failed; empty for success.
std::string finish_query(PGconn* connection, Postgres::Rows& rows) {
  const auto deadline = Clock::now() + kToAnswer;
  std::string fault;
  for (;;) {
    while (PQflush(connection) == 1) {
      if (!wait_for(connection, POLLIN | POLLOUT, deadline)) return kSilent;
      if (PQconsumeInput(connection) == 0) return first_line(PQerrorMessage(connection));
    }
    while (PQisBusy(connection) != 0) {
      if (!wait_for(connection, POLLIN, deadline)) return kSilent;
      if (PQconsumeInput(connection) == 0) return first_line(PQerrorMessage(connection));
    }
    const Result result(PQgetResult(connection));
    if (!result) return fault;
    const auto status = PQresultStatus(result.get());
    if (status != PGRES_TUPLES_OK && status != PGRES_COMMAND_OK)
      fault = first_line(PQresultErrorMessage(result.get()));
    for (int r = 0; r < PQntuples(result.get()); ++r) {
      Postgres::Row& row = rows.emplace_back();
      for (int c = 0; c < PQnfields(result.get()); ++c)
        row.emplace_back(PQgetvalue(result.get(), r, c),
                         static_cast<std::size_t>(PQgetlength(result.get(), r, c)));
    }
  }
}

}  // namespace

Postgres::Postgres(std::string address, std::vector<std::string> first)
    : address_(std::move(address)), first_(std::move(first)) {}

Postgres::~Postgres() {
  for (pg_conn* connection : idle_) PQfinish(connection);
}

std::string Postgres::fault_of(const std::string& address) {
  char* fault = nullptr;
  PQconninfoOption* const options = PQconninfoParse(address.c_str(), &fault);
  std::string why = fault != nullptr ? first_line(fault) : "";
  PQconninfoFree(options);
  PQfreemem(fault);
  return why;
}

void Postgres::fail(const std::string& why) {
  const std::scoped_lock lock(mutex_);
  left_alone_until_ = Clock::now() + (why == kSilent ? kRestAfterSilence : kRest);
  why_ = why;
  throw error::catalogue_unavailable(why);
}

pg_conn* Postgres::take() {
  {
    std::unique_lock lock(mutex_);
    if (Clock::now() < left_alone_until_) throw error::catalogue_unavailable(why_);
    const auto is_free = [this] { return !idle_.empty() || open_ < kMostConnections; };
    if (!returned_.wait_for(lock, kToBeFree, is_free))
      throw error::catalogue_unavailable("all connections are busy");
    if (!idle_.empty()) {
      pg_conn* const connection = idle_.back();
      idle_.pop_back();
      return connection;
    }
    ++open_;
  }
  return connect();
}

pg_conn* Postgres::connect() {
  pg_conn* const connection = PQconnectStart(address_.c_str());
  std::string fault = connection == nullptr ? "no memory" : finish_connecting(connection);
  Rows ignored;
  for (auto sql = first_.begin(); fault.empty() && sql != first_.end(); ++sql)
    fault = PQsendQuery(connection, sql->c_str()) == 0 ? first_line(PQerrorMessage(connection))
                                                       : finish_query(connection, ignored);
  if (fault.empty()) return connection;
  give_back(connection, false);
  fail(fault);
}

void Postgres::give_back(pg_conn* connection, bool whole) {
  if (!whole) PQfinish(connection);
  const std::scoped_lock lock(mutex_);
  if (whole) {
    idle_.push_back(connection);
  } else {
    --open_;
  }
  returned_.notify_one();
}

Postgres::Borrowed::Borrowed(Postgres& owner) : owner_(owner), connection_(owner.take()) {
  // The server may have gone since it was used last.
  if (PQconsumeInput(connection_) == 1 && PQstatus(connection_) == CONNECTION_OK) {
    whole_ = true;
    return;
  }
  PQfinish(connection_);
  connection_ = owner_.connect();
  whole_ = true;
}

Postgres::Borrowed::~Borrowed() {
  owner_.give_back(connection_, whole_ && PQtransactionStatus(connection_) == PQTRANS_IDLE);
}

Postgres::Rows Postgres::Borrowed::query(const char* sql, const std::vector<std::string>& values) {
  std::vector<const char*> texts;
  for (const std::string& value : values) texts.push_back(value.c_str());
  whole_ = false;
  PQsetnonblocking(connection_, 1);
  Rows rows;
  const bool sent = PQsendQueryParams(connection_, sql, static_cast<int>(texts.size()), nullptr,
                                      texts.data(), nullptr, nullptr, 0) == 1;
  const std::string fault =
      sent ? finish_query(connection_, rows) : first_line(PQerrorMessage(connection_));
  if (!fault.empty()) owner_.fail(fault);
  whole_ = true;
  return rows;
}

Postgres::Rows Postgres::query(const char* sql, const std::vector<std::string>& values) {
  return Borrowed(*this).query(sql, values);
}

}  // namespace remeshd
