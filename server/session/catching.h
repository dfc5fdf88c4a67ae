#pragma once

#include <exception>
#include <new>

#include "engine/base/error.h"
#include "server/admission/contained.h"
#include "server/admission/load_error.h"

namespace remeshd {

/// Calls `work`; passes its Error, or one that stands for any other exception, to `failed`.
template <typename Work, typename Failed>
void catching(Work&& work, Failed&& failed) {
  try {
    work();
  } catch (const Error& failure) {
    failed(failure);
  } catch (const std::bad_alloc&) {
    failed(error::out_of_memory());
  } catch (const std::exception& failure) {
    failed(error::internal("request", failure.what()));
  } catch (...) {
    failed(error::internal("request", "an exception of unknown type"));
  }
}

}  // namespace remeshd
