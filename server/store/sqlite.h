#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct sqlite3;
struct sqlite3_stmt;

namespace remeshd {

/// A connection to an SQLite database. Failures throw Error(Internal, `INDEX_FAILED`).
class Sqlite {
 public:
  /// One prepared statement: bind, then step through the rows.
  class Statement {
   public:
    Statement(Sqlite& database, std::string_view sql);
    ~Statement();
    Statement(const Statement&) = delete;
    Statement& operator=(const Statement&) = delete;

    /// Binds the next parameter, from the first on.
    Statement& bind(std::string_view text);
    Statement& bind(std::int64_t number);
    /// Whether there is another row.
    bool step();
    /// Runs a statement that gives no rows.
    void run();
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::int64_t number(int column) const;

   private:
    Sqlite& database_;
    sqlite3_stmt* statement_ = nullptr;
    int bound_ = 0;
  };

  explicit Sqlite(const std::string& file);

  void execute(const char* sql);
  /// The same; a failure is passed over.
  void try_execute(const char* sql) noexcept;
  Statement prepare(std::string_view sql) { return {*this, sql}; }

 private:
  [[noreturn]] void fail() const;
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
};

}  // namespace remeshd
