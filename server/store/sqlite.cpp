#include "server/store/sqlite.h"

#include <sqlite3.h>

#include <new>

#include "engine/base/error.h"

namespace remeshd {
namespace {

constexpr std::size_t kMostTexts = 64;

}  // namespace

void Sqlite::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

void Sqlite::fail() const {
  Error failure =
      error::internal("store", std::string("the index failed: ") +
                                   (database_ ? sqlite3_errmsg(database_.get()) : "out of memory"));
  failure.info().reason = "INDEX_FAILED";
  throw failure;
}

Sqlite::Sqlite(const std::string& file) {
  sqlite3* database = nullptr;
  const int result =
      sqlite3_open_v2(file.c_str(), &database,
                      SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_FULLMUTEX, nullptr);
  database_.reset(database);
  if (result != SQLITE_OK) fail();
  sqlite3_busy_timeout(database, 5000);
}

void Sqlite::execute(const char* sql) {
  if (sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK) fail();
}

void Sqlite::try_execute(const char* sql) noexcept {
  sqlite3_exec(database_.get(), sql, nullptr, nullptr, nullptr);
}

Sqlite::~Sqlite() {
  for (const auto& [text, statements] : idle_)
    for (sqlite3_stmt* const statement : statements) sqlite3_finalize(statement);
}

sqlite3_stmt* Sqlite::prepared(std::string_view sql) {
  const auto idle = idle_.find(std::string(sql));
  if (idle != idle_.end() && !idle->second.empty()) {
    sqlite3_stmt* const statement = idle->second.back();
    idle->second.pop_back();
    return statement;
  }
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()), &statement,
                         nullptr) != SQLITE_OK)
    fail();
  return statement;
}

void Sqlite::give_back(sqlite3_stmt* statement) noexcept {
  sqlite3_reset(statement);
  sqlite3_clear_bindings(statement);
  try {
    const std::string text = sqlite3_sql(statement);
    // Filters and orders of lists make many texts, of which few are used again.
    if (idle_.contains(text) || idle_.size() < kMostTexts) {
      idle_[text].push_back(statement);
      return;
    }
  } catch (const std::bad_alloc&) {
    // It is prepared again when it is needed.
  }
  sqlite3_finalize(statement);
}

Sqlite::Statement::Statement(Sqlite& database, std::string_view sql)
    : database_(database), statement_(database.prepared(sql)) {}
Sqlite::Statement::~Statement() { database_.give_back(statement_); }

Sqlite::Statement& Sqlite::Statement::bind(std::string_view text) {
  if (sqlite3_bind_text(statement_, ++bound_, text.data(), static_cast<int>(text.size()),
                        SQLITE_TRANSIENT) != SQLITE_OK)
    database_.fail();
  return *this;
}
Sqlite::Statement& Sqlite::Statement::bind(std::int64_t number) {
  if (sqlite3_bind_int64(statement_, ++bound_, number) != SQLITE_OK) database_.fail();
  return *this;
}

bool Sqlite::Statement::step() {
  const int result = sqlite3_step(statement_);
  if (result == SQLITE_ROW) return true;
  if (result != SQLITE_DONE) database_.fail();
  return false;
}
void Sqlite::Statement::run() {
  while (step()) {
  }
}

std::string Sqlite::Statement::text(int column) const {
  const auto* bytes = reinterpret_cast<const char*>(sqlite3_column_text(statement_, column));
  return bytes == nullptr
             ? std::string()
             : std::string(bytes,
                           static_cast<std::size_t>(sqlite3_column_bytes(statement_, column)));
}
std::int64_t Sqlite::Statement::number(int column) const {
  return sqlite3_column_int64(statement_, column);
}

}  // namespace remeshd
