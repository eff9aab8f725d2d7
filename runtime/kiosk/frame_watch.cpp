#include "runtime/kiosk/frame_watch.h"

namespace docent::kiosk {
namespace {

/// Allocations while drawing, but for a software driver's that compiles a shader: its calls come
/// from its own libraries, and while those run, inline functions of the standard library that it
/// shares with this program look like ours. So such a frame's drawing is not counted; all others'
/// is.
std::uint64_t own_allocations_since(const Allocations& before) noexcept {
  const Allocations now = allocations_on_this_thread();
  const bool driver_allocated = now.all - before.all != now.own - before.own;
  return driver_allocated ? 0 : now.own - before.own;
}

}  // namespace

FrameWatch::FrameWatch() noexcept
    : before_(allocations_on_this_thread()), begun_(thread_cpu_now()) {}

void FrameWatch::stepped() noexcept {
  stepped_ = thread_cpu_now();
}

void FrameWatch::uploaded() noexcept {
  uploaded_ = thread_cpu_now();
}

void FrameWatch::listed() noexcept {
  listed_ = thread_cpu_now();
  made_ = allocations_on_this_thread();
}

void FrameWatch::end(bool is_drawn, bool is_usual, Statistics& statistics) noexcept {
  statistics.frame_cpu.add(stepped_ - begun_ + (listed_ - uploaded_));
  if (is_drawn) statistics.gl.add(uploaded_ - stepped_ + (thread_cpu_now() - listed_));
  if (is_usual)
    statistics.allocations_in_frames += made_.all - before_.all + own_allocations_since(made_);
}

}  // namespace docent::kiosk
