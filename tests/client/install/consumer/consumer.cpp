// Uses a bit of everything that is installed. Nobody listens on port 1: that must be told so.
#include <remeshd/client.h>
#include <remeshd/mesh_file.h>

#include <cstdio>

int main() {
  namespace client = remeshd::client;
  client::Mesh mesh;
  mesh.nodes = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  if (client::to_inp(mesh).find("4, 0.0, 0.0, 1.0") == std::string::npos) return 1;
  try {
    (void)client::Client::connect("127.0.0.1:1").info();
  } catch (const client::CallError& e) {
    std::puts(e.what());
    return e.code() == remesh::v1::Error::CODE_UNAVAILABLE ? 0 : 2;
  }
  return 3;
}
