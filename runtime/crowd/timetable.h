#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/crowd/course.h"

namespace docent {

/// A body that would be come too near to.
struct Conflict {
  double seconds = 0;
  std::uint32_t body = 0;  ///< The other one.
};

/// The courses to which all bodies of a floor are committed. Whoever wants to go somewhere is free
/// to do so where no other's course is: so nobody ever walks into anybody (prioritised planning,
/// Erdmann and Lozano-Perez 1987; every course ends standing, which is always safe).
class Timetable {
 public:
  explicit Timetable(double body_radius) : radius_(body_radius) {}

  double body_radius() const noexcept { return radius_; }

  /// Commits a body to a course; whatever it was committed to is void.
  void put(std::uint32_t body, Course course);
  void remove(std::uint32_t body) noexcept;

  /// Null for a body that is not here.
  const Course* course_of(std::uint32_t body) const noexcept;

  /// Of all others, whom a body on this course would first come nearer than two radii and `spare`,
  /// and when.
  std::optional<Conflict> first_conflict(std::uint32_t body, const Course& course, double spare,
                                         double from) const noexcept;

  struct Entry {
    std::uint32_t body = 0;
    Course course;
  };
  /// In order of their bodies.
  std::span<const Entry> entries() const noexcept { return entries_; }

 private:
  double radius_;
  std::vector<Entry> entries_;
};

}  // namespace docent
