#include "common/words.hpp"

#include <map>

namespace clapotis {
namespace {

constexpr Words english{
    .unknown_parameter = "the scene has no parameter {name}; it has: {known}",
    .unknown_name = "there is no {kind} {name}; there is: {known}",
    .did_you_mean = "; did you mean {name}?",
    .value_out_of_range = "{name} = {value}{unit} is out of range: {name} must be {allowed}",
    .not_a_number = "{name} = {value} is not a finite number",
    .not_an_integer = "{name} = {value} is not a whole number: {name} must be {allowed}",
    .not_a_choice = "{name} = {value} is not one of: {allowed}",
    .comma_for_dot = "{name} = {value} is not a number: decimals are written with a dot, 0.5",
    .derived_parameter = "{name} follows from other parameters and cannot be set",
    .too_many_discs = "particles = {count} discs of radius {radius} {unit} do not fit: at most {most} do",
    .box_too_small =
        "radius = {radius} {unit} is too large: the disc needs a box wider than 2 radius, not {side} {unit}",
    .outside_box =
        "{name} = {value} {unit} is outside the walls: {name} must be between {low} and {high} {unit}",
    .no_time_step =
        "dt = auto finds no limit to take a share of (nothing moves, nothing falls): give dt a number of "
        "seconds",
    .threads_out_of_range = "threads = {value} is out of range: threads must be at least 1",
    .any_finite = "any finite number",
    .range_above = "> {low}",
    .range_at_least = ">= {low}",
    .range_at_most = "<= {high}",
    .range_between = "between {low} and {high}",
    .or_auto = ", or auto",
    .diverged = "diverged at step {step}, t = {time} s, particle {particle}: {cause}",
    .diverged_speed =
        "its speed {speed} {unit} is beyond all that the scene's energy allows ({bound} {unit})",
    .diverged_nan = "its position or velocity is not a number",
    .cause_limit = "; dt = {dt} s is {ratio} times the {limit} limit {formula}",
    .cause_scheme =
        "; {integrator} is not stable here at dt = {dt} s: take a smaller dt or another integrator",
    .beyond_limit = "dt = {dt} s is {ratio} times the {limit} limit {formula}: expect the run to diverge",
    .warn_coincident =
        "{count} times two particles were at one point; they were pushed apart in a direction "
        "taken from their ids",
    .warn_folded =
        "{count} times a particle crossed the box more often in one step than is followed; its "
        "reflections were counted instead",
};

const std::map<std::string_view, std::string_view>& meanings() {
  static const std::map<std::string_view, std::string_view> table{
      {"mass", "mass of a particle"},
      {"radius", "radius of a particle"},
      {"gravity", "weight per unit of mass"},
      {"drag", "friction of the air"},
      {"restitution", "share of the normal speed kept by a wall"},
      {"width", "width of the box"},
      {"height", "height of the box"},
      {"x0", "initial abscissa"},
      {"y0", "initial height"},
      {"vx0", "initial velocity along x"},
      {"vy0", "initial velocity along y"},
      {"dt", "time step"},
      {"cfl", "share of h/c that a step takes"},
      {"impacts", "impacts located inside the step, or clamped after it"},
      {"particles", "number of particles"},
      {"stiffness", "stiffness of a contact"},
      {"seed", "seed of the random placement"},
      {"mass_ratio", "mass of the second disc over that of the first"},
  };
  return table;
}

}  // namespace

const Words& words() { return english; }

std::string_view meaning(std::string_view name) {
  const auto found = meanings().find(name);
  return found == meanings().end() ? name : found->second;
}

}  // namespace clapotis
