#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "client/cli/connect.h"
#include "client/cli/interrupt.h"
#include "client/cli/run.h"

int main(int argc, char** argv) {
  using namespace remeshd;
  // Before any other thread starts, so that all of them leave the signals to this one.
  cli::Interrupt interrupt;
  const char* kind = std::getenv("TERM");
  const bool dumb = kind == nullptr || std::string_view(kind) == "dumb";
  return cli::run({argv + 1, argv + argc}, {.out = std::cout,
                                            .err = std::cerr,
                                            .terminal = ::isatty(STDERR_FILENO) == 1 && !dumb,
                                            .stop = interrupt.token(),
                                            .connect = cli::connect});
}
