#include <unistd.h>

#include <cstdlib>
#include <iostream>

#include "client/cli/connect.h"
#include "client/cli/interrupt.h"
#include "client/cli/run.h"
#include "client/cli/terminal.h"

int main(int argc, char** argv) {
  using namespace remeshd;
  // Before any other thread starts, so that all of them leave the signals to this one.
  cli::Interrupt interrupt;
  return cli::run({argv + 1, argv + argc},
                  {.in = std::cin,
                   .out = std::cout,
                   .err = std::cerr,
                   .terminal = cli::can_draw(STDERR_FILENO, std::getenv("TERM")),
                   .stop = interrupt.token(),
                   .connect = cli::connect});
}
