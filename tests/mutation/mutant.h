#pragma once

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <concepts>
#include <cstddef>
#include <cstdlib>
#include <type_traits>

// Included by the mutated copies of sources (README.md), never by the sources themselves.

/// What the environment says of the mutants, read once a process.
struct RemeshdMutants {
  int chosen = -1;                   ///< REMESHD_MUTANT: number of the fault that is made; -1: none
  unsigned char* reached = nullptr;  ///< the file REMESHD_MUTANTS_REACHED: a byte for each number
  std::size_t size = 0;              ///< bytes of `reached`

  RemeshdMutants() {
    if (const char* number = std::getenv("REMESHD_MUTANT")) chosen = std::atoi(number);
    const char* name = std::getenv("REMESHD_MUTANTS_REACHED");
    const int file = name ? open(name, O_RDWR | O_CLOEXEC) : -1;
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

/// Whether fault n is to be made here; notes that this place was reached, where that is asked for.
inline bool remeshd_mutant(int n) {
  static const RemeshdMutants mutants;
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
