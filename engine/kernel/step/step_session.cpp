#include "engine/kernel/step/step_session.h"

#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <Standard_Failure.hxx>
#include <mutex>

#include "engine/base/error.h"

namespace remeshd::kernel {

void with_step_translator(const std::function<void()>& work) {
  static std::mutex one_at_a_time;
  const std::scoped_lock lock(one_at_a_time);
  try {
    static const bool ready = [] {
      Message::DefaultMessenger()->ChangePrinters().Clear();
      STEPControl_Controller::Init();
      Interface_Static::SetCVal("write.step.schema", "AP214IS");
      Interface_Static::SetCVal("write.step.assembly", "Off");
      // Curves in the parameters of a surface say nothing that the curves in space do not.
      Interface_Static::SetIVal("write.surfacecurve.mode", 0);
      return true;
    }();
    if (ready) work();
  } catch (const Standard_Failure& failure) {
    throw error::kernel_failure(failure.GetMessageString());
  }
}

}  // namespace remeshd::kernel
