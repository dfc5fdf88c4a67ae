#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

// What libFuzzer calls, each with the bytes of one run; all return 0. An input may end in an error
// of the kind that the code under test promises; anything else that is thrown is a finding.

int fuzz_model_json(const std::uint8_t* data, std::size_t size);
int fuzz_edit(const std::uint8_t* data, std::size_t size);
int fuzz_requests(const std::uint8_t* data, std::size_t size);
int fuzz_store_record(const std::uint8_t* data, std::size_t size);
int fuzz_array_codec(const std::uint8_t* data, std::size_t size);
int fuzz_revision_image(const std::uint8_t* data, std::size_t size);
int fuzz_journal(const std::uint8_t* data, std::size_t size);
int fuzz_config(const std::uint8_t* data, std::size_t size);
int fuzz_mesh_stream(const std::uint8_t* data, std::size_t size);
int fuzz_mesh_file(const std::uint8_t* data, std::size_t size);

namespace remeshd::fuzz {

/// Inputs to begin with, made of real documents, messages and files.
using Seeds = std::vector<std::string>;
Seeds model_json_seeds();
Seeds edit_seeds();
Seeds request_seeds();
Seeds store_record_seeds();
Seeds array_codec_seeds();
Seeds revision_image_seeds();
Seeds journal_seeds();
Seeds config_seeds();
Seeds mesh_stream_seeds();
Seeds mesh_file_seeds();

struct Target {
  const char* name;
  int (*run)(const std::uint8_t* data, std::size_t size);
  Seeds (*seeds)();
};

inline constexpr Target kTargets[] = {
    {"model_json", fuzz_model_json, model_json_seeds},
    {"edit", fuzz_edit, edit_seeds},
    {"requests", fuzz_requests, request_seeds},
    {"store_record", fuzz_store_record, store_record_seeds},
    {"array_codec", fuzz_array_codec, array_codec_seeds},
    {"revision_image", fuzz_revision_image, revision_image_seeds},
    {"journal", fuzz_journal, journal_seeds},
    {"config", fuzz_config, config_seeds},
    {"mesh_stream", fuzz_mesh_stream, mesh_stream_seeds},
    {"mesh_file", fuzz_mesh_file, mesh_file_seeds},
};

}  // namespace remeshd::fuzz
