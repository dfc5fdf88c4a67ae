#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <string>
#include <type_traits>

// Included by the mutated copies of sources (README.md), never by the sources themselves.

/// The value of a variable; of the process that started this one where this one has no environment,
/// as the helper that runs TetGen has none. Empty where it is not set.
inline std::string remeshd_variable(const std::string& name) {
  if (environ != nullptr && *environ != nullptr) {
    const char* value = std::getenv(name.c_str());
    return value != nullptr ? value : "";
  }
  std::ifstream of_parent("/proc/" + std::to_string(getppid()) + "/environ");
  for (std::string entry; std::getline(of_parent, entry, '\0');)
    if (entry.starts_with(name + "=")) return entry.substr(name.size() + 1);
  return {};
}

/// What the environment says of the mutants, read once a process.
struct RemeshdMutants {
  int chosen = -1;                   ///< MUTANT: number of the fault that is made; -1: none
  unsigned char* reached = nullptr;  ///< the file MUTANTS_REACHED: a byte for each number
  std::size_t size = 0;              ///< bytes of `reached`

  RemeshdMutants() {
    const std::string number = remeshd_variable("MUTANT");
    if (!number.empty()) chosen = std::atoi(number.c_str());
    const std::string name = remeshd_variable("MUTANTS_REACHED");
    const int file = name.empty() ? -1 : open(name.c_str(), O_RDWR | O_CLOEXEC);
    if (file < 0) return;
    struct stat status = {};
    if (fstat(file, &status) == 0 && status.st_size > 0) {
      size = static_cast<std::size_t>(status.st_size);
      // Shared, so that what a process reached before it crashed is in the file.
      void* bytes = mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
      if (bytes != MAP_FAILED) reached = static_cast<unsigned char*>(bytes);
    }
    close(file);
  }
};

inline const RemeshdMutants& remeshd_mutants() {
  static const RemeshdMutants mutants;
  return mutants;
}
/// Read before main: the helper that runs TetGen opens no file later.
inline const bool remeshd_mutants_are_read = (remeshd_mutants(), true);

/// Whether fault n is to be made here; notes that this place was reached, where that is asked for.
inline bool remeshd_mutant(int n) {
  const RemeshdMutants& mutants = remeshd_mutants();
  if (mutants.reached != nullptr && static_cast<std::size_t>(n) < mutants.size)
    mutants.reached[n] = 1;
  return n == mutants.chosen;
}

/// The same in a constexpr function: no fault while the compiler evaluates it.
constexpr bool remeshd_constexpr_mutant(int n) {
  if (std::is_constant_evaluated()) return false;
  return remeshd_mutant(n);
}

/// `other` in place of `one` where there is a fault. Both have the same type, so that without the
/// fault nothing is converted.
template <class T, class U>
requires std::same_as<std::remove_const_t<T>, std::remove_const_t<U>>
constexpr auto& remeshd_either(bool fault, T& one, U& other) { return fault ? other : one; }
