#pragma once

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <vector>

struct pg_conn;

namespace remeshd {

/// Connections to a PostgreSQL database, a few that stay open and are shared. A statement that is
/// not answered in time is given up together with its connection; after any failure the database is
/// left alone for a moment. For any thread.
///
/// All functions throw Error(CATALOGUE_UNAVAILABLE).
class Postgres {
 public:
  /// The columns of a row, as text.
  using Row = std::vector<std::string>;
  using Rows = std::vector<Row>;

  /// `address`: as libpq takes it, `postgresql://USER@HOST/DATABASE?...`. `first`: statements that
  /// are run on every new connection.
  Postgres(std::string address, std::vector<std::string> first);
  ~Postgres();
  Postgres(const Postgres&) = delete;
  Postgres& operator=(const Postgres&) = delete;

  /// Runs one statement. NULL becomes an empty text.
  Rows query(const char* sql, const std::vector<std::string>& values);
  /// A connection for several statements in a row.
  class Borrowed {
   public:
    explicit Borrowed(Postgres& owner);
    ~Borrowed();
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    Rows query(const char* sql, const std::vector<std::string>& values = {});

   private:
    Postgres& owner_;
    pg_conn* connection_;
    bool whole_ = false;  ///< the connection can be used again
  };

  /// What is wrong with an address by its syntax; empty for nothing.
  static std::string fault_of(const std::string& address);

 private:
  using Clock = std::chrono::steady_clock;
  pg_conn* take();
  pg_conn* connect();
  void give_back(pg_conn* connection, bool whole);
  [[noreturn]] void fail(const std::string& why);

  const std::string address_;
  const std::vector<std::string> first_;
  std::mutex mutex_;  ///< guards what follows
  std::condition_variable returned_;
  std::vector<pg_conn*> idle_;
  int open_ = 0;
  Clock::time_point left_alone_until_;
  std::string why_;
};

}  // namespace remeshd
