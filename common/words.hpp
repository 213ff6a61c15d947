#pragma once

#include <fmt/core.h>

#include <string>
#include <string_view>

#include "common/language.hpp"
#include "common/word.hpp"

namespace clapotis {

/// Every word that the window and the command line show, in one language. A hole is written {name}. A
/// language that lacks a word, or a hole of a sentence, does not compile.
struct Words {
  // what a user gave and cannot be used
  Word unknown_parameter, unknown_name, did_you_mean, value_out_of_range, not_a_number, not_an_integer,
      not_a_choice, comma_for_dot, needs_restart, derived_parameter, too_many_discs, box_too_small,
      outside_box, no_time_step, vanishing_time_step, too_many_steps, other_unit, from_place,
      threads_out_of_range, spacing_too_large, spacing_too_small, no_room_for_drop, obstacle_over_liquid,
      no_sound_speed, entry_twice, integrator_of_particles;
  // ranges of values
  Word any_finite, range_above, range_at_least, range_at_most, range_between, or_auto, each_or_none, none;
  // what a run says
  Word diverged, diverged_speed, diverged_nan, cause_limit, cause_scheme, beyond_limit, warn_coincident,
      warn_coincident_fluid, warn_folded;
  // runner: what a command line or a file gives and cannot be used
  Word unknown_option, option_is_parameter, option_needs_value, option_takes_no_value, one_scene_at_a_time,
      set_without_equals, empty_value, no_seed, environment_ignored, needs_headless, needs_window,
      beside_without_equals, picture_extension, config_unknown_key, config_wrong_kind, config_no_value,
      config_key_twice, config_not_json, config_other_stage, config_resumed, video_extension, option_without;
  // runner: saved states
  Word state_no_state, state_other_format, state_cut_short, state_damaged, state_other_version,
      state_other_width, state_other_build, state_other_scene, state_contradiction, state_at_end,
      resume_and_config;
  // runner: videos
  Word no_encoder, encoder_failed, encoder_ended;
  // runner: files, displays, ends
  Word cannot_read, cannot_write, folder_exists, not_a_folder, not_a_run_folder, no_display, interrupted,
      no_memory, own_fault, standard_output, no_greek_letters, no_letters;
  // runner: what a run prints
  Word progress, summary_run, summary_cost, summary_energy, summary_error, summary_saved, summary_warning,
      stopped_done, stopped_interrupted, stopped_diverged;
  // runner: tables, plots, pictures
  Word column_name, column_symbol, column_unit, column_default, column_range, column_change, column_meaning,
      plot_energies, plot_error, kinetic, potential, elastic, internal, mechanical, total, measured_points;
  // runner: comparison
  Word compare_side, compare_assignment, compare_two_sides, compare_two_ends, compare_units,
      compare_other_particles, compare_other_start, compare_title, compare_side_line, compare_left,
      compare_right, compare_end, compare_largest, compare_ratio, compare_cost, compare_plot,
      compare_distance, compare_curve_largest, compare_curve_rms, help_compare, help_side, help_compare_steps,
      help_compare_every, help_compare_out, help_compare_json;
  // runner: help
  Word help_scene, help_headless, help_until, help_steps, help_set, help_config, help_print_config,
      help_preset, help_colour_by, help_integrator, help_seed, help_threads, help_out, help_force, help_every,
      help_frames, help_vtk, help_picture, help_video, help_video_every, help_save, help_resume, help_list,
      help_json, help_quiet, help_paused, help_beside, help_scale, help_theme, help_lang, help_version,
      help_help, help_epilogue, help_usage, help_arguments;

  // window: its own table, so that its many short words need no prefix
  struct Window {
    // the buttons and the rows of the panel
    Word run, pause, step, reset, speed, slower_than_asked, scene, preset, integrator, live, restart,
        defaults, automatic, type_hint, time_step, close_to_instability, beyond_stability, view, colour_by,
        lock_range, grid, vectors, plots, letters, dark, cost, particles, step_cost, real_time, picture,
        video, stop_video, table, grid_file, save, restore, recording, pairs_near, pairs_tested, frames,
        frame_cost;
    // what is painted over the scene
    Word particle, position, velocity, speed_of_particle, acceleration, near, velocity_scale, diverged,
        try_another;
    // notices
    Word picture_saved, state_saved, state_restored, nothing_saved;
    Word mouse, tool_probe, tool_pull, tool_push, tool_add, tool_erase, tool_obstacle, tool_grab;
    // the help
    Word help_title, help_close, key_click, key_wheel, key_middle_drag, key_control_click, does_pause,
        does_step, does_reset, does_speed, does_scene, does_colour, does_lock, does_grid, does_neighbour,
        does_vectors, does_plots, does_panel, does_view, does_save, does_restore, does_video, does_picture,
        does_help, does_quit, does_select, does_zoom, does_pan, does_type, key_right, does_right,
        does_language, does_theme, does_letters, does_sides, does_kernel, does_back;
    // two sides
    struct Sides {
      Word button, started, ended;
      constexpr bool operator==(const Sides&) const = default;
    } sides;
    // inside a particle: its table
    struct Inside {
      Word held, mass, sum, in_walls, in_vain;
      constexpr bool operator==(const Inside&) const = default;
    } inside;
    // the kernel at work
    struct Kernel {
      Word label, contact_label, none, nobody, weight, sum, slope, gradient, fluid, wall, contact, neighbours,
          density, own_density;
      constexpr bool operator==(const Kernel&) const = default;
    } kernel;
    // the time line, and what was before
    struct Past {
      Word back_hint, shown_time, oldest, two_sides;
      constexpr bool operator==(const Past&) const = default;
    } past;
    // the limits of dt, and the ways on where one was passed
    struct Limits {
      Word sets_dt, given, adaptive, hint, stable, accurate, smaller_step, step_back;
      constexpr bool operator==(const Limits&) const = default;
    } limits;
    constexpr bool operator==(const Window&) const = default;
  } window;

  // the exercises of a stage, in a tab of the panel
  struct Lesson {
    Word tab_scene, tab_lesson, exercise, run, steps, in_terminal, changed, expected, show_answer,
        hide_answer;
    constexpr bool operator==(const Lesson&) const = default;
  } lesson;

  // the studies
  struct Study {
    Word help, help_name, help_quick, help_out, help_force, list, done, several_builds, interrupted,
        other_table, damaged_table;
    constexpr bool operator==(const Study&) const = default;
  } study;

  /// What the compiler uses to compare two languages word by word, see Word.
  constexpr bool operator==(const Words&) const = default;
};

/// The words of the language in use.
const Words& words();

/// The words with their holes filled: say(words().not_a_number, fmt::arg("value", text)).
template <class... Args>
std::string say(std::string_view sentence, const Args&... args) {
  return fmt::format(fmt::runtime(sentence), args...);
}

/// Where a name of the code is said: where a person reads a list or a picture, before "limit" of the time
/// step, in a list of limits, or after "there is no".
enum class Naming { list, law, limit, limit_alone, kind };

/// What a name of the code is called where a person reads it: "density_error" is "density error". The name
/// itself when the table has no line for it.
std::string_view called(std::string_view name, Naming where = Naming::list);

/// What a quantity is called in the panel and the help: "gravity" gives "weight per unit of mass". The name
/// itself when the table has no line for it, so that a new law needs none.
std::string_view meaning(std::string_view name);

}  // namespace clapotis
