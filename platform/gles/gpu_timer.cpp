#include "platform/gles/gpu_timer.h"

#include <EGL/egl.h>
#include <GLES3/gl3.h>
// after GLES3: it declares extensions of it
#include <GLES2/gl2ext.h>

#include "platform/gles/extension.h"

namespace docent::gles {
GpuTimer::GpuTimer() {
  if (!has_extension("GL_EXT_disjoint_timer_query")) return;
  get_result_ = reinterpret_cast<GetResult>(eglGetProcAddress("glGetQueryObjectui64vEXT"));
  if (get_result_ != nullptr) glGenQueries(most_in_flight, query_.data());
}

GpuTimer::~GpuTimer() {
  if (get_result_ != nullptr) glDeleteQueries(most_in_flight, query_.data());
}

void GpuTimer::begin() noexcept {
  if (get_result_ == nullptr || asked_ - answered_ == most_in_flight) return;
  glBeginQuery(GL_TIME_ELAPSED_EXT, query_[asked_ % most_in_flight]);
  running_ = true;
}

void GpuTimer::end() noexcept {
  if (!running_) return;
  glEndQuery(GL_TIME_ELAPSED_EXT);
  running_ = false;
  ++asked_;
}

std::optional<std::chrono::nanoseconds> GpuTimer::take() noexcept {
  if (asked_ == answered_) return std::nullopt;
  const GLuint query = query_[answered_ % most_in_flight];
  GLuint is_ready = GL_FALSE;
  glGetQueryObjectuiv(query, GL_QUERY_RESULT_AVAILABLE, &is_ready);
  if (is_ready == GL_FALSE) return std::nullopt;
  std::uint64_t nanoseconds = 0;
  get_result_(query, GL_QUERY_RESULT, &nanoseconds);
  ++answered_;
  return std::chrono::nanoseconds(nanoseconds);
}

}  // namespace docent::gles
