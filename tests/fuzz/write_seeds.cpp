// Writes the seeds of every target to FOLDER/TARGET: write_seeds FOLDER.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "proto/checksum.h"
#include "tests/fuzz/targets.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: fuzz_seeds FOLDER\n";
    return 2;
  }
  for (const remeshd::fuzz::Target& target : remeshd::fuzz::kTargets) {
    const std::filesystem::path folder = std::filesystem::path(argv[1]) / target.name;
    std::filesystem::create_directories(folder);
    for (const std::string& seed : target.seeds())
      std::ofstream(folder / remeshd::sha256_hex(seed).substr(0, 40), std::ios::binary) << seed;
  }
  return 0;
}
