#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "remeshd/mesh.h"

namespace remeshd::client {

template <class T>
void write_raw(const std::filesystem::path& path, const std::vector<T>& values) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(values.data()),
             static_cast<std::streamsize>(values.size() * sizeof(T)));
}

inline std::string json(const std::vector<std::vector<std::string>>& lists) {
  std::string out;
  for (const auto& list : lists) {
    std::string inner;
    for (const auto& name : list) inner += (inner.empty() ? "\"" : ", \"") + name + "\"";
    out += (out.empty() ? "[" : ", [") + inner + "]";
  }
  return "[" + out + "]";
}

/// The mesh as raw arrays, a file each, for the scripts of this folder.
inline void write_raw_arrays(const std::filesystem::path& folder, const Mesh& mesh) {
  write_raw(folder / "points", mesh.nodes);
  write_raw(folder / "tets", mesh.tets);
  write_raw(folder / "origin", mesh.node_origin);
  write_raw(folder / "original_node", mesh.original_node);
  write_raw(folder / "node_id", mesh.node_ids);
  write_raw(folder / "size", mesh.node_sizes);
  write_raw(folder / "original_tet", mesh.original_tet);
  write_raw(folder / "tet_id", mesh.tet_ids);
  write_raw(folder / "cell", mesh.tet_cell);
  write_raw(folder / "facets", mesh.facets);
  write_raw(folder / "mid_points", mesh.mid_nodes);
  write_raw(folder / "tet_mids", mesh.tet_mids);
  write_raw(folder / "mid_origin", mesh.mid_node_origin);
  write_raw(folder / "original_mid_node", mesh.original_mid_node);
  write_raw(folder / "mid_node_id", mesh.mid_node_ids);
  write_raw(folder / "edge_mids", mesh.edge_mids);
  std::ofstream(folder / "names.json") << "{\"facet_groups\": " << json(mesh.facet_groups)
                                       << ", \"cell_owners\": " << json(mesh.cell_owners)
                                       << ", \"groups\": " << json({mesh.group_names}) << "}";
  write_raw(folder / "group_facets", mesh.group_facets);
  write_raw(folder / "group_tets", mesh.group_tets);
}

/// A file of this folder of the sources.
inline std::filesystem::path beside_this(const std::string& name) {
  return std::filesystem::path(REMESHD_CASES_DIR).parent_path() / "client/formats" / name;
}

/// Runs a script of this folder, which fails where a package of deploy/packages-test.txt is
/// missing.
inline testing::AssertionResult run_script(const std::string& name,
                                           const std::vector<std::filesystem::path>& arguments) {
  std::string command = "/usr/bin/python3 " + beside_this(name).string();
  for (const auto& argument : arguments) command += " " + argument.string();
  if (std::system(command.c_str()) == 0) return testing::AssertionSuccess();
  return testing::AssertionFailure() << command;
}

}  // namespace remeshd::client
