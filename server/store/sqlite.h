#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

struct sqlite3;
struct sqlite3_stmt;

namespace remeshd {

/// A connection to an SQLite database, for one thread at a time. Failures throw
/// Error(Internal, `INDEX_FAILED`).
class Sqlite {
 public:
  /// One prepared statement: bind, then step through the rows. Preparing takes longer than running
  /// most of them, so statements are kept for their next use.
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
    const std::string_view sql_;
    sqlite3_stmt* statement_ = nullptr;
    int bound_ = 0;
  };

  explicit Sqlite(const std::string& file);
  ~Sqlite();
  Sqlite(const Sqlite&) = delete;
  Sqlite& operator=(const Sqlite&) = delete;

  void execute(const char* sql);
  /// The same; failures are ignored.
  void try_execute(const char* sql) noexcept;
  Statement prepare(std::string_view sql) { return {*this, sql}; }

 private:
  [[noreturn]] void fail() const;
  sqlite3_stmt* prepared(std::string_view sql);
  void give_back(sqlite3_stmt* statement) noexcept;
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<sqlite3, Close> database_;
  std::unordered_map<std::string, std::vector<sqlite3_stmt*>> idle_;  ///< by their text
};

}  // namespace remeshd
