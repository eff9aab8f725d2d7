#pragma once

#include "runtime/path/tour/tour_costs.h"

namespace docent::bench {

/// No order of all places costs less: the bound of Held and Karp (1970) for one-way costs, by
/// arborescences of least cost (Chu and Liu 1965, Edmonds 1967) whose places are made to have one
/// successor each by subgradient steps. Takes nothing from the code that it judges. `known`: what
/// some order costs.
double lower_bound_of(const path::TourCosts& costs, double known);

}  // namespace docent::bench
