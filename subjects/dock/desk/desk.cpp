#include "subjects/dock/desk/desk.hpp"

#include <new>
#include <string>
#include <system_error>

#include "subjects/dock/desk/commands.hpp"
#include "subjects/dock/futex.hpp"

namespace mmverify::dock {

void Desk::serve() {
  Mailbox& mailbox = caller_.mailbox();
  for (std::uint64_t number = 0;; ++number) {
    while (mailbox.turn.load(std::memory_order_acquire) != 1) futex_wait(mailbox.turn, 0, 1000);
    run(number);
    // A process that the subject forked reaches this line, too.
    if (getpid() != self_) _exit(0);
    mailbox.turn.store(0, std::memory_order_release);
    futex_wake(mailbox.turn);
  }
}

void Desk::run(std::uint64_t number) {
  caller_.finish(Outcome::answered, 0, "");
  try {
    caller_.check_mode_of_loading();
    if (caller_.entry().signature.of_blob)
      run_on_blob(caller_, kept_);
    else
      run_on_numbers(caller_, kept_, number);
    caller_.check_the_process(number);
  } catch (const Caller::Stop&) {
  } catch (const std::system_error& e) {  // from std::thread; guarded() catches the subject's exceptions
    caller_.finish(Outcome::no_resources, 0, std::string("cannot start a thread: ") + e.what());
  } catch (const std::bad_alloc&) {
    caller_.finish(Outcome::no_resources, 0, "cannot get memory");
  }
}

}  // namespace mmverify::dock
