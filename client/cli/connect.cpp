#include "client/cli/connect.h"

#include "client/cli/exit_code.h"
#include "client/cli/store_folder.h"

namespace remeshd::cli {

client::Client connect(const GlobalOptions& options) {
  return client::Client::connect(options.address);
}

}  // namespace remeshd::cli
