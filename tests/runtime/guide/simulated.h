#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "runtime/guide/guide.h"

namespace docent::test {

/// Letters as boxes: views without fonts.
inline interface::TextBitmap boxes(const interface::TextStyle& style, std::string_view text,
                                   std::uint32_t width) {
  std::uint32_t letters = 0;
  for (const char c : text) letters += (static_cast<unsigned char>(c) & 0xC0U) != 0x80U ? 1U : 0U;
  interface::TextBitmap bitmap;
  bitmap.lines = 1;
  bitmap.width = std::min<std::uint32_t>(8 * letters + 1, width == 0 ? 4000 : width);
  bitmap.height = static_cast<std::uint32_t>(style.size);
  bitmap.coverage.resize(std::size_t{bitmap.width} * bitmap.height, 255);
  return bitmap;
}

/// Sixty frames a second of simulated time: the worker's answers are there in the next step.
inline void run(plan::Planner& planner, guide::Guide& guide, double seconds) {
  constexpr guide::Seconds frame{1.0F / 60};
  for (long i = 0; i < std::lround(seconds * 60); ++i) {
    planner.wait();
    guide.step(frame);
    while (guide.take_pieces() != nullptr) continue;
    guide.draw_list();
  }
}

/// Touches a control of the glass of one visitor.
inline void tap(plan::Planner& planner, guide::Guide& guide, std::string_view name) {
  const auto& controls = guide.view()->controls;
  const auto control = std::ranges::find(controls, name, &interface::Control::name);
  ASSERT_NE(control, controls.end()) << name;
  const scene::Rect& at = control->rect;
  const input::Contact finger{1, at.x + at.width / 2, at.y + at.height / 2};
  for (const auto kind : {input::InputEvent::Kind::Down, input::InputEvent::Kind::Up}) {
    guide.touch({.kind = kind, .contact = finger});
    run(planner, guide, 1.0 / 60);
  }
}

}  // namespace docent::test
